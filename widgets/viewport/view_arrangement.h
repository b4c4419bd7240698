// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QStringList>
#include <functional>
#include <memory>
#include <vector>

namespace mocapress {

struct Pose;

/// Ways to compare the original and the compressed figure.
enum class ViewMode {
  Overlay,     // one figure over the other, the original as a ghost
  SideBySide,  // each figure in one half
  Wipe,        // one picture, with the original to the left of a divider
};

/// The user's choices for the view.
struct ViewOptions {
  ViewMode mode = ViewMode::Overlay;
  bool swapped = false;     // the figures change places
  bool blinking = false;    // the figures take turns in one place
  bool alone = false;       // hides the original, which the camera still frames and follows
  bool by_error = false;    // colours the compressed figure by its distance from the original
  bool skin = true;         // shows figures with their skin, if they have one
  bool path = false;        // shows the path of the chosen joint, or of the root
  bool in_place = false;    // keeps the root in place over the ground
  double divider = 0.5;     // share of the view's width left of the wipe's divider
  int trail = 0;            // number of faded poses before the current frame, and as many after
  bool quartered = false;   // four views: from anywhere, front, side and top; figures overlaid
  double exaggeration = 1;  // factor on the difference from the original
  bool titles = true;       // names the figures
  float room = 1;  // distance of a framing camera, times what a figure needs to fill the view

  bool operator==(const ViewOptions&) const = default;
};

/// Views of a quartered window, from the top left: from anywhere, front, side, top.
inline constexpr int kQuarters = 4;

/// The largest number of pinned results beside the current one.
inline constexpr int kMostPinned = 4;
inline constexpr int kMostPanes = 2 + kMostPinned;

/// An upright strip of the view in normalised device coordinates: its content moves sideways by
/// `shift` and is clipped to `from` and `to`.
struct Pane {
  float shift = 0;
  float from = -1;
  float to = 1;

  bool contains(float device_x) const { return from <= device_x && device_x <= to; }
  bool operator==(const Pane&) const = default;
};

/// The strip `index` of `count` equal ones, from the left, with its content moved to its middle.
Pane paneOf(int index, int count);

struct Placement {
  bool shown = true;
  bool ghost = false;
  Pane pane;

  bool operator==(const Placement&) const = default;
};

/// The place and style of each figure.
struct Arrangement {
  Placement original;
  Placement compressed;
  std::vector<Placement> pinned;
  int panes = 1;             // number of equal parts of the view, each with a ground
  bool quartered = false;    // the window has four views, each with all figures
  bool has_divider = false;  // at the right end of the left figure's pane

  const Placement& left() const;
  float dividerAt() const { return left().pane.to; }
};

/// Arranges the figures. `both`: original and compressed are there, else one stands alone. `turn`:
/// a blinking view shows the compressed one. `pinned` results are ghosts over the others or stand
/// each in a pane of its own; wipes and blinking views hide them.
Arrangement arrange(const ViewOptions& options, bool both, bool turn, int pinned = 0);

/// Another result of the clip, shown beside the current one.
struct PinnedFigure {
  std::shared_ptr<const Eigen::MatrixXd> tracks;  // frames x 3 * landmarks, cm
  QColor colour;
  QStringList title;  // its lines are joined into one where there is room for it
  std::function<void(int frame, Pose& pose)> poses;  // poses for its skin; empty: it has none
};

}  // namespace mocapress
