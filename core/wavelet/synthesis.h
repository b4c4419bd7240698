// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// What one unit of a coefficient adds to the signal: zero but for a stretch of samples.
struct SynthesisFunction {
  int first;  // sample
  Eigen::Map<const Eigen::VectorXd> values;
};

/// The synthesis functions of a transform, for work on single coefficients. Away from the borders
/// those of a band are shifts of one another and kept once.
class Synthesis {
 public:
  explicit Synthesis(const Lifting& lifting);

  SynthesisFunction operator[](int coefficient) const {
    const Place& place = places_[static_cast<std::size_t>(coefficient)];
    return {place.first, {values_.data() + place.values, place.size}};
  }

 private:
  struct Place {
    int first;
    int size;
    Eigen::Index values;  // index into values_
  };

  Place add(const Lifting& lifting, int coefficient);

  std::vector<Place> places_;
  std::vector<double> values_;
};

}  // namespace mocapress
