// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3.1.
#pragma once

#include <Eigen/Core>

#include "core/motion/landmarks.h"

namespace mocapress {

/// Where the largest distance is.
struct WorstPoint {
  int frame = 0;
  int landmark = 0;  // index into landmarks(skeleton)
  double cm = 0;
};

/// How far a decoded clip is from its original, in centimetres.
struct Distortion {
  double eps_bone_ends = 0;  // the paper's eps_x with each weighting
  double eps_joint_origins = 0;
  double p95 = 0;  // over all landmarks and frames, unweighted
  double p99 = 0;
  WorstPoint max;
  Eigen::MatrixXf distances;  // frames x landmarks

  double eps(Weighting weighting) const {
    return weighting == Weighting::BoneEnds ? eps_bone_ends : eps_joint_origins;
  }
};

/// Measures a clip whose tracks come some frames at a time, each once.
class DistortionMeter {
 public:
  /// `original_tracks` are landmark_tracks(); both must outlive this.
  DistortionMeter(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks);

  /// landmark_tracks() of the decoded clip from first_frame on.
  void add(int first_frame, const Eigen::MatrixXd& decoded_tracks);

  /// Once all are there.
  Distortion distortion() const;
  double eps(Weighting weighting) const;

 private:
  const Skeleton& skeleton_;
  const Eigen::MatrixXd& original_tracks_;
  Eigen::MatrixXd squared_;  // frames x landmarks, cm^2
};

/// Compares clips of one skeleton. Requires equal shapes.
Distortion measure(const Skeleton& skeleton, const Clip& original, const Clip& decoded);

/// The same against landmark_tracks(skeleton, original) computed before.
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Clip& decoded);

/// The same of two landmark_tracks().
Distortion measure(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                   const Eigen::MatrixXd& decoded_tracks);

/// eps_x alone, by full forward kinematics: the exact value the quadratic model approximates.
double exact_eps(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                 const Clip& decoded, Weighting weighting);

}  // namespace mocapress
