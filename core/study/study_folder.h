// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/codec/encode/encoder.h"
#include "core/report/report_language.h"
#include "core/study/results.h"
#include "core/study/run.h"

namespace mocapress {

/// The files of a study in its folder.
inline constexpr const char* kRowsSoFar = "rows.jsonl";  // rows that a stopped study resumes from
inline constexpr const char* kRowsCsv = "rows.csv";
inline constexpr const char* kRowsJson = "rows.json";
inline constexpr const char* kReport = "report.html";

/// Runs a study and keeps its rows in `folder`, so that a study that was stopped or killed
/// continues when it is run again. Rows of other targets and methods are kept for later runs.
/// Creates the folder. Throws InputError and WriteError.
StudyOutcome run_study_kept(const std::filesystem::path& folder, const StudyPlan& plan,
                            const Observer<StudyProgress>& observer = {});

/// Makes the report of rows, which may be a part of the plan's. Pictures are compressed again, from
/// the clips that can be read; `warnings` names the others. Unset if the observer, which several
/// threads call, stopped it.
std::optional<std::string> study_report(const StudyPlan& plan, const Results& results,
                                        const Observer<EncodeProgress>& observer = {},
                                        Warnings* warnings = nullptr,
                                        const ReportLanguage& language = {});

/// Runs run_study_kept() and, once all rows are there, writes the tables and the report. If the
/// observer stops the study before that, the tables and report of an earlier run stay.
StudyOutcome run_study_in(const std::filesystem::path& folder, const StudyPlan& plan,
                          const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
