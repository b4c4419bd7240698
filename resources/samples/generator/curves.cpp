// SPDX-License-Identifier: MIT
#include "resources/samples/generator/curves.h"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>

namespace mocapress::samples {

double eased(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

double KeyTrack::at(double seconds) const {
  const auto next = std::ranges::find_if(keys_, [&](const Key& k) { return k.seconds > seconds; });
  if (next == keys_.begin()) return keys_.front().value;
  if (next == keys_.end()) return keys_.back().value;
  const Key& from = *std::prev(next);
  const double share = (seconds - from.seconds) / (next->seconds - from.seconds);
  return from.value + (next->value - from.value) * eased(share);
}

Eigen::Vector3d BallisticTrack::at(double seconds) const {
  const auto next =
      std::ranges::find_if(knots_, [&](const Knot& k) { return k.seconds > seconds; });
  if (next == knots_.begin() || next == knots_.end()) {
    const Knot& end = next == knots_.end() ? knots_.back() : knots_.front();
    return end.position + end.velocity * (seconds - end.seconds);
  }
  const Knot& from = *std::prev(next);
  const double duration = next->seconds - from.seconds;
  const double s = (seconds - from.seconds) / duration;
  const Eigen::Vector3d v0 = from.velocity * duration;
  const Eigen::Vector3d v1 = next->velocity * duration;
  const Eigen::Vector3d a0 = from.acceleration * duration * duration / 2;
  const Eigen::Vector3d a1 = next->acceleration * duration * duration / 2;
  // The second knot minus the end of the parabola from the first: position, velocity, acceleration.
  const Eigen::Vector3d p = next->position - from.position - v0 - a0;
  const Eigen::Vector3d v = v1 - v0 - 2 * a0;
  const Eigen::Vector3d a = a1 - a0;
  return from.position + s * v0 + s * s * a0 +
         s * s * s *
             ((10 * p - 4 * v + a) + s * ((7 * v - 15 * p - 2 * a) + s * (6 * p - 3 * v + a)));
}

ClampedSpline::ClampedSpline(std::vector<double> seconds, Eigen::MatrixXd values,
                             const Eigen::RowVectorXd& first_velocity,
                             const Eigen::RowVectorXd& last_velocity)
    : seconds_(std::move(seconds)), values_(std::move(values)) {
  const auto count = static_cast<Eigen::Index>(seconds_.size());
  assert(count >= 2 && values_.rows() == count);
  const auto step = [&](Eigen::Index i) {
    return seconds_[static_cast<std::size_t>(i + 1)] - seconds_[static_cast<std::size_t>(i)];
  };
  // One row a knot: accelerations agree on both of its sides.
  Eigen::MatrixXd system = Eigen::MatrixXd::Identity(count, count);
  Eigen::MatrixXd wanted(count, values_.cols());
  wanted.row(0) = first_velocity;
  wanted.row(count - 1) = last_velocity;
  for (Eigen::Index i = 1; i + 1 < count; ++i) {
    const double before = 1 / step(i - 1);
    const double after = 1 / step(i);
    system.row(i).segment<3>(i - 1) << before, 2 * (before + after), after;
    wanted.row(i) = 3 * (before * before * (values_.row(i) - values_.row(i - 1)) +
                         after * after * (values_.row(i + 1) - values_.row(i)));
  }
  velocities_ = system.partialPivLu().solve(wanted);
}

Eigen::RowVectorXd ClampedSpline::at(double seconds) const {
  const auto after = std::upper_bound(seconds_.begin() + 1, seconds_.end() - 1, seconds);
  const auto i = static_cast<Eigen::Index>(after - seconds_.begin()) - 1;
  const double start = *std::prev(after);
  const double duration = *after - start;
  const double s = (seconds - start) / duration;
  const double towards = s * s * (3 - 2 * s);
  return (1 - towards) * values_.row(i) + towards * values_.row(i + 1) +
         duration * s * (1 - s) * ((1 - s) * velocities_.row(i) - s * velocities_.row(i + 1));
}

}  // namespace mocapress::samples
