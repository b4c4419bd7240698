// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <span>

#include "core/mocapress/motion.h"

namespace mocapress {

/// Transforms of all joints in their parents' frames; a root's is in the world. 7 x joints, a
/// column for each joint: the unit quaternion w x y z of parent_from_joint, then the joint's origin
/// x y z in cm.
struct LocalPose {
  Eigen::Matrix<float, 7, Eigen::Dynamic> joints;

  Eigen::Quaternionf rotation(int joint) const;
  Eigen::Vector3f translation(int joint) const { return joints.col(joint).tail<3>(); }
};

/// The rule at a clip's ends: time stops, or a loop goes round.
enum class AtEnds { Hold, Loop };

/// A .mcpr opened for playing. It decodes any instant by itself, by the runtime decoder and with
/// the clip's IK correction. Const and safe to use from several threads at a time. Engines that
/// manage their own memory take mocapress_runtime.h instead.
class Player {
 public:
  /// The bytes are not needed afterwards. Throws FormatError for bytes that are no .mcpr, and for
  /// what engines do not play: codings other than adaptive, and the comparison methods.
  /// decompress() reads those.
  explicit Player(std::span<const std::byte> file);
  ~Player();

  const Skeleton& skeleton() const;  // skeleton().find(name) is a joint's index
  int frames() const;
  double sample_rate_hz() const;
  double seconds()
      const;  // Duration: one turn of a loop, otherwise from the first frame to the last.
  bool is_loop() const;

  /// The pose at an instant. At a frame it is the coded pose; between two frames the channels are
  /// linear. Before the first frame and after the last, AtEnds::Hold gives the pose of that frame.
  /// AtEnds::Loop goes round instead; it does not add up the root's path. Throws Error for an
  /// instant that is not finite, and for AtEnds::Loop if the clip is no loop.
  LocalPose sample(double seconds, AtEnds at_ends = AtEnds::Hold) const;

  /// The joints' origins in the world at that instant: 3 x joints, cm.
  Eigen::Matrix3Xf positions(double seconds, AtEnds at_ends = AtEnds::Hold) const;

  /// Morph weights, properties and scales, with their values at all frames.
  const ScalarTracks& tracks() const;

  /// The value of each at that instant: linear between frames, or in steps.
  Eigen::VectorXf track_values(double seconds, AtEnds at_ends = AtEnds::Hold) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// Decodes a .mcpr of any method to a motion in its source's channels, with the source's format for
/// write_motion(). Throws FormatError.
MotionFile decompress(std::span<const std::byte> file);

}  // namespace mocapress
