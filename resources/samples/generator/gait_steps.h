// SPDX-License-Identifier: MIT
#pragma once

#include "core/base/random.h"
#include "resources/samples/generator/gait.h"

namespace mocapress::samples {

/// The arc that the body follows.
class GaitPath {
 public:
  explicit GaitPath(const Gait& gait) : gait_(gait) {}

  double distance(double seconds) const;  // cm gone by the body
  double heading(double distance) const;  // radians about y
  /// On the floor, `left` of the arc (cm).
  Eigen::Vector3d place(double distance, double left) const;

 private:
  Gait gait_;
};

struct Feet {
  FootPlan left;
  FootPlan right;
};

/// Where and when the feet come down, no two steps quite alike.
Feet plan_steps(const Gait& gait, Random& random);

}  // namespace mocapress::samples
