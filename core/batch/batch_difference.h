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

/// Changes of a clip from an earlier batch to a later one, the gravest first.
enum class ClipChange {
  Failed,        // done in the earlier batch, failed in the later one
  NewlyVisible,  // visibility rose to borderline or visible
  Worse,         // mean or largest error grew
  Larger,        // the motion takes more bytes
  Gone,          // missing in the later batch
  Added,         // missing in the earlier batch
  Done,          // failed in the earlier batch, done in the later one
  NoLongerSeen,  // visibility fell
  Better,        // mean or largest error fell, and neither grew
  Smaller,
};

inline constexpr std::array kClipChanges = {
    ClipChange::Failed, ClipChange::NewlyVisible, ClipChange::Worse, ClipChange::Larger,
    ClipChange::Gone,   ClipChange::Added,        ClipChange::Done,  ClipChange::NoLongerSeen,
    ClipChange::Better, ClipChange::Smaller};

/// The name of a change: "failed", "newly-visible", "worse", "larger", "gone", "added", "done",
/// "no-longer-visible", "better" or "smaller".
std::string_view name(ClipChange change);
std::optional<ClipChange> clip_change_named(std::string_view word);

/// Measurements of a clip in a batch.
struct ClipFigures {
  bool done = false;
  std::size_t bytes = 0;  // of the motion
  double eps_cm = 0;      // mean error in the weighting of its compression
  Weighting weighting = {};
  double max_cm = 0;
  std::optional<Sight> sight;
  SightLimits limits;  // limits by which `sight` was judged
  std::string reason;  // why the clip failed; of a clip that did not, the worst visible error
};

/// Takes a clip's measurements from its row of the batch.
ClipFigures figures_of(const BatchRow& row);

/// Returns a clip's changes, the gravest first. Values that differ by less than `share` count as
/// equal, and so do errors that differ by less than a hundredth of a millimetre. Mean errors are
/// not compared if their weightings differ, nor is visibility if its limits or distances differ.
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
  std::size_t clips = 0;         // done in both batches
  std::size_t bytes_before = 0;  // bytes of motion of these clips
  std::size_t bytes_after = 0;
  std::size_t judged_otherwise = 0;     // not compared in visibility, since limits differ
  std::vector<ClipDifference> changed;  // gravest change first, then in the order of outputs

  std::size_t count(ClipChange change) const;
};

/// Compares the clips of two batches that have the same output, as changes_of() does.
BatchDifference difference_of(const BatchRows& before, const BatchRows& after, double share);

Json to_json(const BatchDifference& difference);

}  // namespace mocapress
