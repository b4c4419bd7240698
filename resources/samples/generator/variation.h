// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/base/random.h"

namespace mocapress::samples {

/// Between -1 and 1, triangular around 0.
double jitter(Random& random);

/// The part that differs from stride to stride: a sum of sinusoids from 0.25 to 15 Hz, slow ones
/// larger, of about unit root mean square.
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

/// The noise that cameras add: independent from frame to frame, nearly Gaussian, of unit standard
/// deviation.
double sensor_noise(Random& random);

/// The drift and tremble of one angle of a joint (degrees, root mean square).
struct Unrest {
  double drift;
  double noise;
};
Unrest unrest_of(const std::string& joint);

}  // namespace mocapress::samples
