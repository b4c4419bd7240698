// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"

namespace mocapress::samples {

/// Between -1 and 1, triangular around 0.
double jitter(Random& random);

/// What no two strides have in common: a sum of sinusoids from 0.25 to 15 Hz, slow ones larger, of
/// about unit root mean square.
class Drift {
 public:
  explicit Drift(Random& random);
  double at(double seconds) const;

 private:
  struct Wave {
    double radians_per_second;
    double phase;
    double amplitude;
  };
  std::vector<Wave> waves_;
};

/// What cameras add: independent from frame to frame, nearly Gaussian, of unit standard deviation.
double sensor_noise(Random& random);

/// How much one angle of a joint drifts and trembles (degrees, root mean square).
struct Unrest {
  double drift;
  double noise;
};
Unrest unrest_of(const std::string& joint);

}  // namespace mocapress::samples
