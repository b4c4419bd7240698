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

/// Progress of a study.
struct StudyProgress {
  int jobs = 0;
  int done = 0;                        // finished ones, including kept ones
  int kept = 0;                        // those among them from an earlier run
  const StudyRow* finished = nullptr;  // the row just finished; null: only a chance to stop
};

/// Takes each new row. Called by one thread at a time.
using RowSink = std::function<void(const StudyRow&)>;

struct StudyOutcome {
  std::vector<StudyRow> rows;  // in the order of jobs_of(plan), not of their ends
  Warnings warnings;     // from the readers, in the order of the clips, and from the rows' file
  bool complete = true;  // false: the observer stopped it, and some rows are missing
};

/// Compresses every clip by every method at every target, on all cores. A failure becomes a row
/// with its reason; only exceptions of the sink get out. Rows of `earlier` with the same key() are
/// not measured again. The observer is called by one thread at a time, after each row and in
/// between; it must not throw.
StudyOutcome run_study(const StudyPlan& plan, std::span<const StudyRow> earlier = {},
                       const RowSink& sink = {}, const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
