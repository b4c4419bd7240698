// SPDX-License-Identifier: MIT
// A correction that makes a knee snap is worse than none: how fast it turns tells.
#pragma once

#include <vector>

#include "core/ik/effector.h"
#include "core/motion/clip.h"

namespace mocapress {

/// The joint that bends an effector's limb: the second of its chain, or the only one.
int knee_of(const Effector& effector);

/// The fastest turn of any of some effectors' knees from one frame to the next, of a clip that
/// comes some frames at a time, in time.
class KneeSpeed {
 public:
  /// Both must outlive this.
  KneeSpeed(const Skeleton& skeleton, const std::vector<Effector>& effectors);

  void add(const Clip& frames);
  double fastest() const { return fastest_; }  // radians/s

 private:
  const Skeleton& skeleton_;
  const std::vector<Effector>& effectors_;
  std::vector<Eigen::Matrix3d> last_;  // of each knee, its rotation at the last frame
  double fastest_ = 0;
};

/// The same of a whole clip.
double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip);

}  // namespace mocapress
