// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <span>

#include "core/mocapress/motion.h"

namespace mocapress {

/// Where every joint is in its parent's frame: 7 x joints, a column each, the unit quaternion w x y
/// z of parent_from_joint, then the joint's origin x y z in cm. A root's are in the world.
struct LocalPose {
  Eigen::Matrix<float, 7, Eigen::Dynamic> joints;

  Eigen::Quaternionf rotation(int joint) const;
  Eigen::Vector3f translation(int joint) const { return joints.col(joint).tail<3>(); }
};

/// Whether time stops at a clip's ends or, where the clip is a loop, goes round.
enum class AtEnds { Hold, Loop };

/// A .mcpr opened to be played: any instant by itself, through the runtime decoder and with the
/// clip's IK correction. Const and safe to use from several threads at a time. Engines that have
/// their own memory take mocapress_runtime.h instead.
class Player {
 public:
  /// The bytes may go afterwards. Throws FormatError for what is no .mcpr, and for what engines do
  /// not play: codings other than adaptive, and the comparison methods. See decompress().
  explicit Player(std::span<const std::byte> file);
  ~Player();

  const Skeleton& skeleton() const;  // skeleton().find(name) is a joint's index
  int frames() const;
  double sample_rate_hz() const;
  double seconds() const;  // of one turn of a loop; else from the first frame to the last
  bool is_loop() const;

  /// At frames the coded pose, between two linear in the channels. Instants before the first and
  /// after the last frame are theirs; with AtEnds::Loop a turn before or after, the way of the root
  /// not added up. Throws Error for AtEnds::Loop of a clip that is no loop and an instant that is
  /// not finite.
  LocalPose sample(double seconds, AtEnds at_ends = AtEnds::Hold) const;

  /// The same as origins in the world: 3 x joints, cm.
  Eigen::Matrix3Xf positions(double seconds, AtEnds at_ends = AtEnds::Hold) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// A .mcpr of any method as the motion it was made of, nearly: in the source's channels, with its
/// source's format for write_motion(). Throws FormatError.
MotionFile decompress(std::span<const std::byte> file);

}  // namespace mocapress
