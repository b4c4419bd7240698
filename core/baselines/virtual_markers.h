// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/forward_kinematics.h"

namespace mocapress {

/// Poses as points: three markers for each joint that turns and is no root, a bone's length along
/// its axes, relative to the root. They describe a pose without the hierarchy of its angles.
class VirtualMarkers {
 public:
  explicit VirtualMarkers(const Skeleton& skeleton);

  /// Number of coordinates of a frame's markers.
  Eigen::Index coordinates() const { return 9 * std::ssize(places_); }

  /// The channels that markers do not determine: all of the roots' and all translations.
  const std::vector<int>& other_channels() const { return other_channels_; }
  /// The angles that markers determine.
  const std::vector<int>& angles() const { return angles_; }

  /// Places of the markers (cm), in the root's frame.
  Eigen::RowVectorXd of(const FrameRow& frame) const;

  /// Sets the angles of `frame`, which holds those of the frame before, so that the joints turn to
  /// the markers.
  void turn(const Eigen::RowVectorXd& markers, Eigen::RowVectorXd& frame) const;

 private:
  struct Place {
    int joint;
    double arm;  // cm
  };

  const Skeleton& skeleton_;
  std::vector<int> roots_;  // each joint's root
  std::vector<Place> places_;
  std::vector<int> other_channels_;
  std::vector<int> angles_;
};

}  // namespace mocapress
