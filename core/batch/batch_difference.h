// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/batch/report.h"

namespace mocapress {

/// A change of a clip from one batch to a later one, the gravest first.
enum class ClipChange {
  Failed,        // it was done, and failed in the later batch
  NewlyVisible,  // visibility rose to borderline or visible
  Worse,         // mean or largest error
  Larger,        // bytes of motion
  Gone,          // the later batch does not have it
  Added,         // the earlier batch did not have it
  Done,          // it had failed
  NoLongerSeen,  // visibility fell
  Better,        // mean or largest error, and neither is worse
  Smaller,
};

inline constexpr std::array kClipChanges = {
    ClipChange::Failed, ClipChange::NewlyVisible, ClipChange::Worse, ClipChange::Larger,
    ClipChange::Gone,   ClipChange::Added,        ClipChange::Done,  ClipChange::NoLongerSeen,
    ClipChange::Better, ClipChange::Smaller};

/// "failed", "newly-visible", "worse", "larger", "gone", "added", "done", "no-longer-visible",
/// "better", "smaller".
std::string_view name(ClipChange change);
std::optional<ClipChange> clip_change_named(std::string_view word);

/// Measurements of a clip in a batch.
struct ClipFigures {
  bool done = false;
  std::size_t bytes = 0;  // the motion's
  double eps_cm = 0;      // in the weighting it was compressed by
  Weighting weighting = {};
  double max_cm = 0;
  std::optional<Sight> sight;
  SightLimits limits;  // limits by which `sight` was judged
  std::string reason;  // the worst visible error, or why the clip failed
};

/// The figures in a row.
ClipFigures figures_of(const BatchRow& row);

/// The changes of a clip, the gravest first. Bytes and errors that differ by less than `share` are
/// the same, and so are errors that differ by less than a hundredth of a millimetre. Mean errors in
/// different weightings are not compared, nor is visibility by different limits or from different
/// distances.
std::vector<ClipChange> changes_of(const std::optional<ClipFigures>& before,
                                   const std::optional<ClipFigures>& after, double share);

/// A clip that changed.
struct ClipDifference {
  std::string output;
  std::optional<ClipFigures> before;  // unset: not in the earlier batch
  std::optional<ClipFigures> after;
  std::vector<ClipChange> changes;  // the gravest first
};

struct BatchDifference {
  std::size_t clips = 0;         // done in both
  std::size_t bytes_before = 0;  // bytes of motion of these clips
  std::size_t bytes_after = 0;
  std::size_t judged_otherwise = 0;     // by other limits: their visibility is not compared
  std::vector<ClipDifference> changed;  // the gravest change first, then by output

  std::size_t count(ClipChange change) const;
};

/// Compares two batches, clip by clip of the same output, as changes_of() does.
BatchDifference difference_of(const BatchRows& before, const BatchRows& after, double share);

Json to_json(const BatchDifference& difference);

}  // namespace mocapress
