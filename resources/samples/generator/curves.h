// SPDX-License-Identifier: MIT
// Based on: Flash & Hogan, "The coordination of arm movements", J. Neuroscience 5(7), 1985: an
// unhurried human movement from rest to rest minimises jerk.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace mocapress::samples {

/// 0 before share 0, 1 after share 1, minimum jerk between.
double eased(double share);

/// Minimum-jerk movements from key to key, at rest at each; constant outside them.
class KeyTrack {
 public:
  struct Key {
    double seconds;
    double value;
  };
  explicit KeyTrack(std::vector<Key> keys) : keys_(std::move(keys)) {}
  double at(double seconds) const;

 private:
  std::vector<Key> keys_;  // in order of time
};

/// A path through knots that state position, velocity and acceleration; quintic between, so that
/// between two knots of one ballistic flight it is that flight. Straight on outside the knots.
class BallisticTrack {
 public:
  struct Knot {
    double seconds;
    Eigen::Vector3d position;      // cm
    Eigen::Vector3d velocity;      // cm/s
    Eigen::Vector3d acceleration;  // cm/s^2
  };
  explicit BallisticTrack(std::vector<Knot> knots) : knots_(std::move(knots)) {}
  Eigen::Vector3d at(double seconds) const;

 private:
  std::vector<Knot> knots_;  // in order of time
};

/// A cubic spline (continuous acceleration) with given velocities at its ends.
class ClampedSpline {
 public:
  /// Rows of `values` are the values at `seconds`. Requires at least two.
  ClampedSpline(std::vector<double> seconds, Eigen::MatrixXd values,
                const Eigen::RowVectorXd& first_velocity, const Eigen::RowVectorXd& last_velocity);
  Eigen::RowVectorXd at(double seconds) const;

 private:
  std::vector<double> seconds_;
  Eigen::MatrixXd values_;
  Eigen::MatrixXd velocities_;
};

}  // namespace mocapress::samples
