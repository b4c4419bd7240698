// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "core/report/picture.h"

namespace mocapress {

/// A camera that looks at a point, from a little above and from beside the figure's front, and the
/// sheet that it draws on.
struct SceneView {
  Eigen::Vector3d centre;  // the point, in world space (cm)
  Eigen::Vector3d facing;  // horizontal direction in which the figure faces
  double height_cm = 215;  // height of the visible part at the centre
  double width = 520;      // px
  double height = 470;
};

/// Draws a pose over its original, as tapered bones on a floor with a grid.
class SceneSvg {
 public:
  SceneSvg(const Picture& picture, const SceneView& view);

  /// Adds the floor's grid: lines half a metre apart, which fade out from the centre.
  void add_floor();

  void add_shadow(const PosePoints& points);

  /// Adds a figure in the colours of a CSS class: "ghost" or "figure".
  void add_figure(const PosePoints& points, std::string_view css);

  /// Adds the path of points, projected to the floor, with a dot at its end.
  void add_trail(const std::vector<Eigen::Vector3d>& points, std::string_view css);

  /// Adds a line from a point's original to its decoded position, with a ring and a text.
  void add_gap(const Eigen::Vector3d& wanted, const Eigen::Vector3d& found,
               const std::string& text);

  /// Returns the drawing as <svg>, with a label for screen readers.
  std::string finish(std::string_view label) const;

 private:
  struct OnSheet {
    double x, y;   // px
    double scale;  // px per cm at this depth
  };

  OnSheet project(const Eigen::Vector3d& point) const;
  std::string capsule(const DrawnBone& bone, const PosePoints& points) const;

  const Picture& picture_;
  SceneView view_;
  Eigen::Vector3d right_, up_, toward_;  // axes of the camera
  double distance_;                      // cm from the camera to the centre
  std::string content_;
};

}  // namespace mocapress
