// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

#include "core/motion/body_tracks.h"

namespace mocapress {

/// Errors at the ends of a decoded clip. A landmark's error is its decoded position minus its
/// original one. The seam's error is the change of the landmark's error from the last frame to the
/// first, as a loop plays them.
struct EndErrors {
  double first_cm = 0;  // at the first pose, RMS over the body's surface
  double last_cm = 0;
  double seam_cm = 0;            // RMS over the landmarks
  double seam_cm_per_frame = 0;  // the seam's error of velocities
  // Values to compare the seam with: changes between successive frames, RMS over the clip and
  // largest.
  double neighbours_cm = 0;
  double neighbours_cm_per_frame = 0;
  double worst_neighbours_cm = 0;
  double worst_neighbours_cm_per_frame = 0;

  bool operator==(const EndErrors&) const = default;
};

/// Compares clips whose tracks arrive in blocks of frames, each once.
class EndErrorMeter {
 public:
  /// Takes clips of skeletons with this number of landmarks.
  explicit EndErrorMeter(Eigen::Index landmarks) : landmarks_(landmarks) {}

  /// Adds rows of body_tracks() of both clips, and the squared error (cm^2) of the body's surface
  /// at each.
  void add(const TrackRows& original, const TrackRows& decoded, const Eigen::VectorXd& squares);

  EndErrors errors() const;

 private:
  Eigen::Index landmarks_;
  Eigen::Index frames_ = 0;
  std::array<Eigen::RowVectorXd, 2> first_;  // errors of the first two frames, cm
  // Errors of the last two frames so far, the last one first.
  std::array<Eigen::RowVectorXd, 2> last_;
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
  Squares changes_;  // over all successive frames
  Squares bends_;
};

}  // namespace mocapress
