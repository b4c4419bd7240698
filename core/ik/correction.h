// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 5.1.

#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/ik/effector.h"
#include "core/ik/solve.h"
#include "core/motion/clip.h"

namespace mocapress {

/// World positions (cm) of the effectors, frames x 3 * effectors, taken from landmark_tracks().
Eigen::MatrixXd effector_tracks(const Eigen::MatrixXd& landmark_tracks,
                                const std::vector<Effector>& effectors);

/// The distances by which a correction missed its targets.
struct CorrectionReport {
  double worst_miss_cm = 0;
  int unreached = 0;    // limbs at frames with an effector more than kReachedCm from its target
  long iterations = 0;  // iterations of the solver over all frames

  /// Adds the report of further frames.
  void add(const CorrectionReport& other);
};

/// Moves each effector by `differences` (frames x 3 * effectors, cm, world space) by turning the
/// joints of its chain. A frame's result depends on that frame alone, so that any frame can be
/// decoded by itself. Frames are solved in parallel.
CorrectionReport apply_correction(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                                  IkSolver solver, const Eigen::MatrixXd& differences, Clip& clip);

// A correction that makes a knee snap is worse than none, so the speed of knees is measured.

/// The joint that bends an effector's limb: the second of its chain, or the only one.
int knee_of(const Effector& effector);

/// The fastest turn of some effectors' knees between successive frames, in a clip whose frames
/// arrive in blocks, in order.
class KneeSpeed {
 public:
  /// Both arguments must outlive this.
  KneeSpeed(const Skeleton& skeleton, const std::vector<Effector>& effectors);

  void add(const Clip& frames);
  double fastest() const { return fastest_; }  // radians/s

 private:
  const Skeleton& skeleton_;
  const std::vector<Effector>& effectors_;
  std::vector<Eigen::Matrix3d> last_;  // each knee's rotation at the last frame
  double fastest_ = 0;
};

/// The fastest turn (radians/s) of these effectors' knees in a whole clip.
double fastest_knee(const Skeleton& skeleton, const std::vector<Effector>& effectors,
                    const Clip& clip);

}  // namespace mocapress
