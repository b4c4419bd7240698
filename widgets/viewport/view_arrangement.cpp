// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_arrangement.h"

#include <algorithm>
#include <utility>

namespace mocapress {
namespace {

constexpr double kLeastShare = 0.02;  // kept on both sides, so that the divider stays within reach

}  // namespace

const Placement& Arrangement::left() const {
  return original.pane.from <= compressed.pane.from ? original : compressed;
}

Pane paneOf(int index, int count) {
  const auto edge = [count](int i) {
    return -1 + 2 * static_cast<float>(i) / static_cast<float>(count);
  };
  const float from = edge(index);
  const float to = edge(index + 1);
  return {(from + to) / 2, from, to};
}

Arrangement arrange(const ViewOptions& options, bool both, bool turn, int pinned) {
  Arrangement arrangement;
  arrangement.pinned.resize(static_cast<std::size_t>(pinned));
  arrangement.quartered = options.quartered;
  Placement& original = arrangement.original;
  Placement& compressed = arrangement.compressed;
  if (!both) return arrangement;
  const ViewMode mode = options.quartered ? ViewMode::Overlay : options.mode;
  const bool has_room = !options.blinking && mode != ViewMode::Wipe;
  for (Placement& each : arrangement.pinned) each.shown = has_room;
  if (options.alone) {
    original.shown = false;
    return arrangement;
  }
  if (options.blinking) {
    original.shown = !turn;
    compressed.shown = turn;
    return arrangement;
  }
  switch (mode) {
    case ViewMode::Overlay:
      (options.swapped ? compressed : original).ghost = true;
      for (Placement& each : arrangement.pinned) each.ghost = true;
      return arrangement;
    case ViewMode::SideBySide:
      arrangement.panes = 2 + pinned;
      original.pane = paneOf(0, arrangement.panes);
      compressed.pane = paneOf(1, arrangement.panes);
      for (int i = 0; i < pinned; ++i)
        arrangement.pinned[static_cast<std::size_t>(i)].pane = paneOf(2 + i, arrangement.panes);
      break;
    case ViewMode::Wipe: {
      const double share = std::clamp(options.divider, kLeastShare, 1 - kLeastShare);
      const auto divider = static_cast<float>(2 * share - 1);
      original.pane.to = divider;
      compressed.pane.from = divider;
      break;
    }
  }
  arrangement.has_divider = true;
  if (options.swapped) std::swap(original.pane, compressed.pane);
  return arrangement;
}

}  // namespace mocapress
