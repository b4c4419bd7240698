// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/view_arrangement.h"

#include <algorithm>
#include <utility>

namespace mocapress {
namespace {

constexpr double kLeastShare = 0.02;  // of the view on either side of the divider, to drag it back

}  // namespace

const Placement& Arrangement::left() const {
  return original.pane.from <= compressed.pane.from ? original : compressed;
}

Arrangement arrange(const ViewOptions& options, bool both, bool turn) {
  Arrangement arrangement;
  Placement& original = arrangement.original;
  Placement& compressed = arrangement.compressed;
  if (!both) return arrangement;
  if (options.blinking) {
    original.shown = !turn;
    compressed.shown = turn;
    return arrangement;
  }
  switch (options.mode) {
    case ViewMode::Overlay:
      (options.swapped ? compressed : original).ghost = true;
      return arrangement;
    case ViewMode::SideBySide:
      arrangement.panes = 2;
      original.pane = {-0.5f, -1, 0};
      compressed.pane = {0.5f, 0, 1};
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
