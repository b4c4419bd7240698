// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <span>

#include "core/mocapress/motion.h"

namespace mocapress {

/// Transforms of all joints in their parents' frames; a root's transform is in world space. Each
/// joint has a column of 7: the unit quaternion w x y z of parent_from_joint, then the joint's
/// origin x y z in cm.
struct LocalPose {
  Eigen::Matrix<float, 7, Eigen::Dynamic> joints;

  Eigen::Quaternionf rotation(int joint) const;
  Eigen::Vector3f translation(int joint) const { return joints.col(joint).tail<3>(); }
};

/// Determines what happens beyond a clip's ends: the end pose holds, or a loop goes round.
enum class AtEnds { Hold, Loop };

/// Plays a .mcpr. Decodes any instant on its own, with the runtime decoder and with the clip's IK
/// correction. Const, and safe to use from several threads at a time. Engines that manage their own
/// memory use mocapress_runtime.h instead.
class Player {
 public:
  /// Opens a .mcpr; its bytes are not needed afterwards. Throws FormatError for bytes that are not
  /// a .mcpr, and for those that engines do not play: codings other than adaptive, and the
  /// comparison methods. decompress() reads these.
  explicit Player(std::span<const std::byte> file);
  ~Player();

  const Skeleton& skeleton() const;  // index of a joint: skeleton().find(name)
  int frames() const;
  double sample_rate_hz() const;
  double seconds()
      const;  // Duration: one turn of a loop, otherwise from the first frame to the last.
  bool is_loop() const;

  /// Returns the pose at an instant. At a frame it is the coded pose; between two frames the
  /// channels are interpolated linearly. Before the first frame and after the last, AtEnds::Hold
  /// gives the pose of that frame. AtEnds::Loop goes round instead, without adding up the root's
  /// path. Throws Error for an instant that is not finite, and for AtEnds::Loop if the clip is not
  /// a loop.
  LocalPose sample(double seconds, AtEnds at_ends = AtEnds::Hold) const;

  /// Returns the joints' origins in world space at an instant: 3 x joints, in cm.
  Eigen::Matrix3Xf positions(double seconds, AtEnds at_ends = AtEnds::Hold) const;

  /// Morph weights, properties and scales, with their values at all frames.
  const ScalarTracks& tracks() const;

  /// Returns the value of each track at an instant: interpolated linearly between frames, or
  /// stepwise.
  Eigen::VectorXf track_values(double seconds, AtEnds at_ends = AtEnds::Hold) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// Decodes a .mcpr of any method to a motion in its source's channels, along with the source's
/// format for write_motion(). Throws FormatError.
MotionFile decompress(std::span<const std::byte> file);

}  // namespace mocapress
