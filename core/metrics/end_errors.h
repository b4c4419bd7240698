// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "core/motion/body_tracks.h"

namespace mocapress {

/// How the ends of a decoded clip fare. The error of a landmark is where it is less where it should
/// be; a seam's is how much that changes from the last frame to the first, as played in a loop.
struct EndErrors {
  double first_cm = 0;  // of the first pose, RMS over the body's surface
  double last_cm = 0;
  double seam_cm = 0;            // RMS over the landmarks
  double seam_cm_per_frame = 0;  // the same of velocities
  // What a seam compares with: frames in a row, RMS over the clip and the worst of them.
  double neighbours_cm = 0;
  double neighbours_cm_per_frame = 0;
  double worst_neighbours_cm = 0;
  double worst_neighbours_cm_per_frame = 0;

  bool operator==(const EndErrors&) const = default;
};

/// Compares clips whose tracks come some frames at a time, each once.
class EndErrorMeter {
 public:
  /// Of skeletons with so many landmarks.
  explicit EndErrorMeter(Eigen::Index landmarks) : landmarks_(landmarks) {}

  /// Rows of body_tracks() of both clips, and how far the body's surface is off at each. cm^2
  void add(const TrackRows& original, const TrackRows& decoded, const Eigen::VectorXd& squares);

  EndErrors errors() const;

 private:
  Eigen::Index landmarks_;
  Eigen::Index frames_ = 0;
  std::array<Eigen::RowVectorXd, 2> first_;  // errors of the first two frames. cm
  std::array<Eigen::RowVectorXd, 2> last_;   // of the last two so far, the last one first
  double first_square_ = 0;
  double last_square_ = 0;
  struct Squares {
    double sum = 0;
    double most = 0;
    void add(double square) {
      sum += square;
      most = std::max(most, square);
    }
  };
  Squares changes_;  // over all frames in a row
  Squares bends_;
};

}  // namespace mocapress
