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
  bool quartered = false;   // four views: free, front, side and top; figures overlaid
  double exaggeration = 1;  // factor on the difference from the original
  bool titles = true;       // names the figures
  float room = 1;           // factor on the camera's distance when it frames a figure

  bool operator==(const ViewOptions&) const = default;
};

/// The views of a quartered window, from the top left: free, front, side, top.
inline constexpr int kQuarters = 4;

/// The largest number of pinned results that are shown beside the current one.
inline constexpr int kMostPinned = 4;
inline constexpr int kMostPanes = 2 + kMostPinned;

/// A vertical strip of the view, in normalised device coordinates. Its content is moved sideways by
/// `shift` and clipped to `from` and `to`.
struct Pane {
  float shift = 0;
  float from = -1;
  float to = 1;

  bool contains(float device_x) const { return from <= device_x && device_x <= to; }
  bool operator==(const Pane&) const = default;
};

/// The strip `index`, from the left, of `count` equal strips. The view's centre moves to the
/// strip's centre.
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
  bool has_divider = false;  // at the right edge of the left figure's pane

  const Placement& left() const;
  float dividerAt() const { return left().pane.to; }
};

/// Arranges the figures. `both`: original and compressed exist; otherwise one stands alone. `turn`:
/// a blinking view now shows the compressed figure. `pinned` results are ghosts over the others, or
/// each has a pane of its own; wipes and blinking views hide them.
Arrangement arrange(const ViewOptions& options, bool both, bool turn, int pinned = 0);

/// Another result of the clip, shown beside the current one.
struct PinnedFigure {
  std::shared_ptr<const Eigen::MatrixXd> tracks;  // frames x 3 * landmarks, cm
  QColor colour;
  QStringList title;                                 // joined into one line where there is room
  std::function<void(int frame, Pose& pose)> poses;  // poses for its skin; empty: no skin
};

}  // namespace mocapress
