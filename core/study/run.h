// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/study/plan.h"
#include "core/study/row.h"

namespace mocapress {

/// How far a study has come.
struct StudyProgress {
  int jobs = 0;
  int done = 0;                        // of them, kept ones too
  int kept = 0;                        // of those, rows of an earlier run
  const StudyRow* finished = nullptr;  // the row that is done now; null: only "go on?" is asked
};

/// Takes each row that was measured anew. Called by one thread at a time.
using RowSink = std::function<void(const StudyRow&)>;

struct StudyOutcome {
  std::vector<StudyRow> rows;  // in the order of jobs_of(plan), whatever the order they ended in
  Warnings warnings;           // of the readers in the order of the clips, and of the rows' file
  bool complete = true;        // false: the observer ended it early, and only some rows are there
};

/// Compresses every clip by every method at every target, on all cores. What fails is a row that
/// says why; only what the sink throws gets out. Rows of `earlier` with the same
/// key() are not measured again. The observer is called by one thread at a time, after each row and
/// in between; it must not throw.
StudyOutcome run_study(const StudyPlan& plan, std::span<const StudyRow> earlier = {},
                       const RowSink& sink = {}, const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
