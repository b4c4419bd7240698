// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3.1.
#pragma once

#include <Eigen/Core>

#include "core/metrics/distance_counts.h"
#include "core/motion/track_blocks.h"

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
  Eigen::MatrixXf distances;  // frames x landmarks; empty where only figures were asked for

  double eps(Weighting weighting) const {
    return weighting == Weighting::BoneEnds ? eps_bone_ends : eps_joint_origins;
  }
};

/// What a DistortionMeter is asked for.
enum class Detail {
  Means,      // eps_x and the worst point
  Figures,    // and percentiles, but for 1 / 4096 of them (DistanceCounts)
  Distances,  // and every distance, from which percentiles are exact
};

/// Compares two clips whose tracks come some frames at a time, each once. Without distances its
/// memory does not grow with them.
class DistortionMeter {
 public:
  /// Of clips of so many frames.
  DistortionMeter(const Skeleton& skeleton, int frames, Detail detail);

  /// Rows of landmark_tracks() of both clips, from first_frame on.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// Once all are there.
  Distortion distortion() const;
  double eps(Weighting weighting) const;
  const WorstPoint& worst() const { return worst_; }

 private:
  Detail detail_;
  Eigen::VectorXd bone_end_weights_;
  Eigen::VectorXd joint_origin_weights_;
  Eigen::VectorXd squares_;  // cm^2, the sum over the frames so far of each landmark
  Eigen::Index frames_ = 0;
  double worst_square_ = -1;  // cm^2
  WorstPoint worst_;
  DistanceCounts counts_;
  Eigen::MatrixXf distances_;
};

/// How far landmarks are apart: frames x landmarks, cm^2.
Eigen::MatrixXd squared_distances(const TrackRows& original, const TrackRows& decoded);

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
