// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/wavelet/lifting.h"

namespace mocapress {

/// The signal that one unit of a coefficient adds: zero outside a run of samples.
struct SynthesisFunction {
  int first;  // sample
  Eigen::Map<const Eigen::VectorXd> values;
};

/// Synthesis functions of a transform, for work on single coefficients. Away from the borders the
/// functions of a band are shifts of one another and stored once.
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

/// A synthesis function in 32-bit floats, followed by zeros up to a multiple of kVector.
class ShortFunction {
 public:
  static constexpr int kVector = 8;

  ShortFunction(int first, int size, const float* values)
      : first_(first), size_(size), values_(values) {}

  int first() const { return first_; }  // sample
  int size() const { return size_; }    // number of values without the zeros
  int end() const { return first_ + size_; }

  /// Calls visit(index, kVector values) for all of it. The last index may reach up to kVector - 1
  /// beyond the last sample.
  template <typename Visit>
  void visit(const Visit& visit) const {
    for (int i = 0; i < size_; i += kVector) visit(first_ + i, Values(values_ + i));
  }

  /// Inner products of samples with the function's values, and with their squares. kVector - 1
  /// samples more must be readable.
  float dot(const float* samples) const;
  float dot_of_squares(const float* samples) const;

  auto values() const { return Eigen::Map<const Eigen::ArrayXf>(values_, size_); }

 private:
  using Vector = Eigen::Array<float, kVector, 1>;
  using Values = Eigen::Map<const Vector>;

  int first_;
  int size_;
  const float* values_;
};

/// The short functions of a transform.
class ShortFunctions {
 public:
  explicit ShortFunctions(const Lifting& lifting);

  ShortFunction operator[](int coefficient) const {
    const Place& place = places_[static_cast<std::size_t>(coefficient)];
    return {place.first, place.size, values_.data() + place.values};
  }

 private:
  struct Place {
    int first;
    int size;
    Eigen::Index values;  // index into values_
  };

  std::vector<Place> places_;
  std::vector<float> values_;
};

}  // namespace mocapress
