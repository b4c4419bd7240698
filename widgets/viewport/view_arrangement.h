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

/// How the original and the compressed figure are set against each other.
enum class ViewMode {
  Overlay,     // one over the other, the original as a ghost
  SideBySide,  // each in its half
  Wipe,        // one picture, the original to the left of a divider
};

/// What the user chose to see.
struct ViewOptions {
  ViewMode mode = ViewMode::Overlay;
  bool swapped = false;   // the figures have changed places
  bool blinking = false;  // they take turns in one place
  bool by_error = false;  // the compressed figure is coloured by its distance from the original
  bool skin = true;       // figures are their skin, where they have one
  bool path = false;      // the way of the chosen joint, or of the root
  bool in_place = false;  // the root does not move over the ground
  double divider = 0.5;   // of the wipe, share of the view's width
  int trail = 0;          // faded poses of the compressed figure before now, and as many after

  bool operator==(const ViewOptions&) const = default;
};

/// Further results of the same clip that are seen beside the current one.
inline constexpr int kMostPinned = 4;
inline constexpr int kMostPanes = 2 + kMostPinned;

/// An upright strip of the view, in normalised device coordinates: what is drawn moves sideways by
/// `shift` and is seen between `from` and `to` only.
struct Pane {
  float shift = 0;
  float from = -1;
  float to = 1;

  bool contains(float device_x) const { return from <= device_x && device_x <= to; }
  bool operator==(const Pane&) const = default;
};

/// One of so many equal strips, from the left; what is drawn is moved to its middle.
Pane paneOf(int index, int count);

struct Placement {
  bool shown = true;
  bool ghost = false;
  Pane pane;

  bool operator==(const Placement&) const = default;
};

/// Where and how each figure is drawn.
struct Arrangement {
  Placement original;
  Placement compressed;
  std::vector<Placement> pinned;
  int panes = 1;             // equal parts of the view with a ground each
  bool has_divider = false;  // between the figures, at the end of the left one's pane

  const Placement& left() const;
  float dividerAt() const { return left().pane.to; }
};

/// `both`: there are two figures to arrange, else one stands alone. `turn` of a blinking view: the
/// compressed figure's. Those that are `pinned` are ghosts where the others are or stand each in a
/// pane of its own; a wipe and a blinking view have no place for them.
Arrangement arrange(const ViewOptions& options, bool both, bool turn, int pinned = 0);

/// Another result of the clip, seen beside the current one.
struct PinnedFigure {
  std::shared_ptr<const Eigen::MatrixXd> tracks;  // frames x 3 * landmarks, cm
  QColor colour;
  QStringList title;  // in one line where there is room, else one below the other
  std::function<void(int frame, Pose& pose)> poses;  // as its skin needs them; empty: it has none
};

}  // namespace mocapress
