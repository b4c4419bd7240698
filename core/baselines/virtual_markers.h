// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/forward_kinematics.h"

namespace mocapress {

/// Poses as points: three markers to each joint that turns and is no root, a bone's length along
/// its axes, seen from the root. They say what a pose is without the hierarchy of the angles.
class VirtualMarkers {
 public:
  explicit VirtualMarkers(const Skeleton& skeleton);

  /// Coordinates of all markers of a frame.
  Eigen::Index coordinates() const { return 9 * std::ssize(places_); }

  /// The channels that markers do not say: all of the roots' and translations.
  const std::vector<int>& other_channels() const { return other_channels_; }
  /// The angles that they do say.
  const std::vector<int>& angles() const { return angles_; }

  /// Where the markers are. cm, in the root's frame.
  Eigen::RowVectorXd of(const FrameRow& frame) const;

  /// Sets the angles of `frame`, which holds those of the frame before, so that the joints turn as
  /// the markers say.
  void turn(const Eigen::RowVectorXd& markers, Eigen::RowVectorXd& frame) const;

 private:
  struct Place {
    int joint;
    double arm;  // cm
  };

  const Skeleton& skeleton_;
  std::vector<int> roots_;  // of each joint
  std::vector<Place> places_;
  std::vector<int> other_channels_;
  std::vector<int> angles_;
};

}  // namespace mocapress
