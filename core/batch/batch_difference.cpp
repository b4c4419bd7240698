// SPDX-License-Identifier: MIT
#include "core/batch/batch_difference.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/names_all.h"
#include "core/report/json_value.h"

namespace mocapress {
namespace {

/// Compares two values: -1 if the value fell, 1 if it rose, 0 if it changed by less than `share`.
int compared(double before, double after, double share) {
  if (after > before * (1 + share)) return 1;
  return after < before * (1 - share) ? -1 : 0;
}

/// Compares two errors in centimetres. They also count as equal if they differ by less than 0.001.
int compared_cm(double before, double after, double share) {
  constexpr double kSameCm = 0.001;
  return std::abs(after - before) < kSameCm ? 0 : compared(before, after, share);
}

Json to_json(const std::optional<ClipFigures>& figures) {
  if (!figures) return {};
  return {{"done", figures->done},
          {"motion_bytes", figures->bytes},
          {"eps_x_cm", figures->eps_cm},
          {"max_error_cm", figures->max_cm},
          {"visibility", figures->sight ? Json(name(*figures->sight)) : Json()},
          {"reason", text_or_null(figures->reason)}};
}

}  // namespace

ClipFigures figures_of(const BatchRow& row) {
  ClipFigures figures{.done = row.done(), .reason = row.error};
  if (!row.measured) return figures;
  figures.bytes = row.measured->motion_bytes;
  figures.weighting = row.preset.weighting;
  figures.eps_cm = row.measured->eps_cm(figures.weighting);
  figures.max_cm = row.measured->max_cm(figures.weighting);
  figures.sight = row.measured->seen.sight();
  figures.limits = row.measured->seen.limits;
  if (row.done()) figures.reason = row.measured->seen.reason;
  return figures;
}

std::vector<ClipChange> changes_of(const std::optional<ClipFigures>& before,
                                   const std::optional<ClipFigures>& after, double share) {
  using enum ClipChange;
  if (!after) return {Gone};
  if (!before) return {Added};
  if (before->done != after->done) return {after->done ? Done : Failed};
  if (!after->done) return {};
  std::vector<ClipChange> changes;
  if (before->sight && after->sight && before->limits == after->limits &&
      *after->sight != *before->sight)
    changes.push_back(*after->sight > *before->sight ? NewlyVisible : NoLongerSeen);
  const int mean =
      before->weighting == after->weighting ? compared_cm(before->eps_cm, after->eps_cm, share) : 0;
  const int largest = compared_cm(before->max_cm, after->max_cm, share);
  if (mean > 0 || largest > 0)
    changes.push_back(Worse);
  else if (mean < 0 || largest < 0)
    changes.push_back(Better);
  const int bytes =
      compared(static_cast<double>(before->bytes), static_cast<double>(after->bytes), share);
  if (bytes != 0) changes.push_back(bytes > 0 ? Larger : Smaller);
  std::ranges::sort(changes);
  return changes;
}

std::string_view name(ClipChange change) {
  constexpr std::string_view kNames[] = {"failed", "newly-visible", "worse", "larger",
                                         "gone",   "added",         "done",  "no-longer-visible",
                                         "better", "smaller"};
  static_assert(names_all<ClipChange>(kNames));
  return kNames[static_cast<std::size_t>(change)];
}

std::optional<ClipChange> clip_change_named(std::string_view word) {
  for (const ClipChange change : kClipChanges)
    if (name(change) == word) return change;
  return std::nullopt;
}

std::size_t BatchDifference::count(ClipChange change) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(changed, [change](const ClipDifference& clip) {
        return std::ranges::find(clip.changes, change) != clip.changes.end();
      }));
}

BatchDifference difference_of(const BatchRows& before, const BatchRows& after, double share) {
  std::map<std::string, ClipDifference> clips;
  before([&](const BatchRow& row) { clips[row.output].before = figures_of(row); });
  after([&](const BatchRow& row) { clips[row.output].after = figures_of(row); });
  BatchDifference difference;
  for (auto& [output, clip] : clips) {
    if (clip.before && clip.after && clip.before->done && clip.after->done) {
      ++difference.clips;
      difference.bytes_before += clip.before->bytes;
      difference.bytes_after += clip.after->bytes;
      if (clip.before->sight && clip.after->sight && clip.before->limits != clip.after->limits)
        ++difference.judged_otherwise;
    }
    clip.output = output;
    clip.changes = changes_of(clip.before, clip.after, share);
    if (!clip.changes.empty()) difference.changed.push_back(std::move(clip));
  }
  std::ranges::stable_sort(difference.changed,
                           [](const ClipDifference& a, const ClipDifference& b) {
                             return a.changes.front() < b.changes.front();
                           });
  return difference;
}

Json to_json(const BatchDifference& difference) {
  Json counts = Json::object();
  for (const ClipChange change : kClipChanges)
    counts[std::string(name(change))] = difference.count(change);
  Json changed = Json::array();
  for (const ClipDifference& clip : difference.changed) {
    Json changes = Json::array();
    for (const ClipChange change : clip.changes) changes.push_back(name(change));
    changed.push_back({{"output", clip.output},
                       {"changes", changes},
                       {"before", to_json(clip.before)},
                       {"after", to_json(clip.after)}});
  }
  return {{"clips", difference.clips},
          {"motion_bytes_before", difference.bytes_before},
          {"motion_bytes_after", difference.bytes_after},
          {"judged_otherwise", difference.judged_otherwise},
          {"counts", counts},
          {"changed", changed}};
}

}  // namespace mocapress
