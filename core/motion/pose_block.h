// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "core/base/parallel.h"
#include "core/motion/skeleton.h"

namespace mocapress {

/// Poses of several frames at a time, one column for each number, so that the processor works on
/// several frames at once: three times as fast as compute_pose() for each, and equal up to the last
/// digit.
class PoseBlock {
 public:
  static constexpr int kMostFrames = 64;

  explicit PoseBlock(const Skeleton& skeleton);

  /// Computes `frames` poses from row `first` of the channels on. `axes` (all frames x 3 *
  /// channels), if given, gets the world axis that each channel turns about or moves along.
  void compute(const Eigen::MatrixXd& channels, int first, int frames,
               Eigen::MatrixXd* axes = nullptr);

  /// Frames x 3, world space: a joint's origin (cm), its axis 0, 1 or 2, and a point fixed to it
  /// (cm).
  auto origin(int joint) const {
    return origins_.block(0, Eigen::Index{3} * joint, frames_, 3).array();
  }
  auto axis(int joint, int axis) const {
    return axes_.block(0, Eigen::Index{9} * joint + 3 * axis, frames_, 3).array();
  }
  auto place(int joint, const Eigen::Vector3d& in_joint) const {
    return origin(joint) + (axis(joint, 0) * in_joint.x() + axis(joint, 1) * in_joint.y() +
                            axis(joint, 2) * in_joint.z());
  }

 private:
  void compute_joint(int joint, const Eigen::MatrixXd& channels, int first, Eigen::MatrixXd* axes);

  /// Sets the axes of `joint` to those of `from` * matrix.
  void multiply(int from, const Eigen::Matrix3d& matrix, int joint);
  void turn(int joint, int axis, const Eigen::Ref<const Eigen::VectorXd>& radians);

  const Skeleton& skeleton_;
  int frames_ = 0;
  Eigen::MatrixXd origins_;  // kMostFrames x 3 * joints
  Eigen::MatrixXd axes_;     // kMostFrames x 9 * joints: x, y, z of each axis
  Eigen::Matrix<double, kMostFrames, 9> before_;
  Eigen::MatrixXd in_parent_;  // kMostFrames x 3: a joint's origin
};

/// Calls visit(poses, first frame, frames) for the frames of a clip from `from` to before `end`, on
/// all cores and in any order. `axes`: see PoseBlock::compute().
template <typename Visit>
void visit_poses(const Skeleton& skeleton, const Eigen::MatrixXd& channels, int from, int end,
                 const Visit& visit, Eigen::MatrixXd* axes = nullptr) {
  constexpr int kBlocks = 4;  // least number of blocks that share a PoseBlock
  const int blocks = (end - from + PoseBlock::kMostFrames - 1) / PoseBlock::kMostFrames;
  parallel_ranges(0, blocks, kBlocks, [&](int first_block, int end_block) {
    PoseBlock poses(skeleton);
    for (int block = first_block; block < end_block; ++block) {
      const int first = from + block * PoseBlock::kMostFrames;
      const int frames = std::min(PoseBlock::kMostFrames, end - first);
      poses.compute(channels, first, frames, axes);
      visit(poses, first, frames);
    }
  });
}

/// Visits all frames of a clip.
template <typename Visit>
void visit_poses(const Skeleton& skeleton, const Eigen::MatrixXd& channels, const Visit& visit,
                 Eigen::MatrixXd* axes = nullptr) {
  visit_poses(skeleton, channels, 0, static_cast<int>(channels.rows()), visit, axes);
}

}  // namespace mocapress
