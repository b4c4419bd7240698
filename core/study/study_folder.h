// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/codec/encode/encoder.h"
#include "core/study/results.h"
#include "core/study/run.h"

namespace mocapress {

/// The files of a study in its folder.
inline constexpr const char* kRowsSoFar = "rows.jsonl";  // what a stopped study goes on from
inline constexpr const char* kRowsCsv = "rows.csv";
inline constexpr const char* kRowsJson = "rows.json";
inline constexpr const char* kReport = "report.html";

/// Runs a study whose rows are kept in `folder` as they come, so that a run that was stopped, or
/// died, is gone on with by running it again; rows of other targets and methods stay for later.
/// Makes the folder. Throws InputError, WriteError.
StudyOutcome run_study_kept(const std::filesystem::path& folder, const StudyPlan& plan,
                            const Observer<StudyProgress>& observer = {});

/// The report of rows, be they all of the plan's or not: its pictures are compressed anew, from the
/// clips that can be read; `warnings` names the others. Unset when the observer, which several
/// threads call, ended it.
std::optional<std::string> study_report(const StudyPlan& plan, const Results& results,
                                        const Observer<EncodeProgress>& observer = {},
                                        Warnings* warnings = nullptr);

/// run_study_kept(), and when all rows are there the tables and the report; an observer that says
/// no before leaves those of an earlier run.
StudyOutcome run_study_in(const std::filesystem::path& folder, const StudyPlan& plan,
                          const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
