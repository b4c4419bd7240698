// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/study/run.h"

namespace mocapress {

/// The files of a study in its folder.
inline constexpr const char* kRowsSoFar = "rows.jsonl";  // what a stopped study goes on from
inline constexpr const char* kRowsCsv = "rows.csv";
inline constexpr const char* kRowsJson = "rows.json";
inline constexpr const char* kReport = "report.html";

/// Runs a study whose rows are kept in `folder` as they come, so that a run that was stopped, or
/// died, is gone on with by running it again; rows of other targets and methods stay for later.
/// When all are there, writes the tables and the report, each beside and renamed; an observer that
/// says no before leaves those of an earlier run. Makes the folder. Throws InputError, WriteError.
StudyOutcome run_study_in(const std::filesystem::path& folder, const StudyPlan& plan,
                          const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
