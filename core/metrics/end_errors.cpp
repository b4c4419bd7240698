// SPDX-License-Identifier: MIT
#include "core/metrics/end_errors.h"

#include <cmath>
#include <utility>

namespace mocapress {

void EndErrorMeter::add(const TrackRows& original, const TrackRows& decoded,
                        const Eigen::VectorXd& squares) {
  for (Eigen::Index t = 0; t < original.rows(); ++t, ++frames_) {
    Eigen::RowVectorXd error =
        decoded.row(t).head(3 * landmarks_) - original.row(t).head(3 * landmarks_);
    if (frames_ == 0) first_square_ = squares(t);
    last_square_ = squares(t);
    if (frames_ < 2) first_[frames_] = error;
    if (frames_ >= 1) changes_.add((error - last_[0]).squaredNorm());
    if (frames_ >= 2) bends_.add((error - 2 * last_[0] + last_[1]).squaredNorm());
    last_[1] = std::exchange(last_[0], std::move(error));
  }
}

EndErrors EndErrorMeter::errors() const {
  EndErrors found{.first_cm = std::sqrt(first_square_), .last_cm = std::sqrt(last_square_)};
  if (frames_ < 3 || landmarks_ == 0) return found;
  const auto rms = [&](double squares, Eigen::Index count) {
    return std::sqrt(squares / static_cast<double>(landmarks_ * count));
  };
  found.seam_cm = rms((first_[0] - last_[0]).squaredNorm(), 1);
  found.seam_cm_per_frame = rms(((first_[1] - first_[0]) - (last_[0] - last_[1])).squaredNorm(), 1);
  found.neighbours_cm = rms(changes_.sum, frames_ - 1);
  found.neighbours_cm_per_frame = rms(bends_.sum, frames_ - 2);
  found.worst_neighbours_cm = rms(changes_.most, 1);
  found.worst_neighbours_cm_per_frame = rms(bends_.most, 1);
  return found;
}

}  // namespace mocapress
