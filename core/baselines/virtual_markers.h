// SPDX-License-Identifier: MIT
// Based on: O. Arikan, "Compression of Motion Capture Databases", 2006.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/forward_kinematics.h"

namespace mocapress {

/// Poses as points that do not depend on a hierarchy of angles. Each joint that turns, except
/// roots, has three markers: one along each of its axes, at a bone's length from its origin. Their
/// coordinates are relative to the root.
class VirtualMarkers {
 public:
  explicit VirtualMarkers(const Skeleton& skeleton);

  /// The number of coordinates of a frame's markers.
  Eigen::Index coordinates() const { return 9 * std::ssize(places_); }

  /// The channels that markers do not determine: all channels of roots, and all translations.
  const std::vector<int>& other_channels() const { return other_channels_; }
  /// The angles that markers determine.
  const std::vector<int>& angles() const { return angles_; }

  /// The places of the markers, in cm and in the root's frame.
  Eigen::RowVectorXd of(const FrameRow& frame) const;

  /// Turns the joints of `frame` to the markers. On entry, the angles of `frame` are those of the
  /// previous frame.
  void turn(const Eigen::RowVectorXd& markers, Eigen::RowVectorXd& frame) const;

 private:
  struct Place {
    int joint;
    double arm;  // distance of the markers from the joint, cm
  };

  const Skeleton& skeleton_;
  std::vector<int> roots_;  // the root above each joint
  std::vector<Place> places_;
  std::vector<int> other_channels_;
  std::vector<int> angles_;
};

}  // namespace mocapress
