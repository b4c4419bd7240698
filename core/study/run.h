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
  int done = 0;                        // finished jobs, including kept ones
  int kept = 0;                        // jobs whose rows come from an earlier run
  const StudyRow* finished = nullptr;  // the row just finished; null between rows
};

/// Takes each new row. Called by one thread at a time.
using RowSink = std::function<void(const StudyRow&)>;

struct StudyOutcome {
  std::vector<StudyRow> rows;  // in the order of jobs_of(plan)
  Warnings warnings;           // of the readers, in the order of the clips, and of the rows' file
  bool complete = true;        // false: the observer stopped the study, and rows are missing
};

/// Compresses each clip by each method to each target, on all cores. A failure becomes a row with
/// its reason. Throws what the sink throws, and std::bad_alloc. Rows of `earlier` with an equal
/// key() are not measured again. The observer is called by one thread at a time, after each row and
/// in between; it must not throw.
StudyOutcome run_study(const StudyPlan& plan, std::span<const StudyRow> earlier = {},
                       const RowSink& sink = {}, const Observer<StudyProgress>& observer = {});

}  // namespace mocapress
