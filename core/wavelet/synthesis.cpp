// SPDX-License-Identifier: MIT
#include "core/wavelet/synthesis.h"

#include <algorithm>
#include <cmath>

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

/// Partial sums over every kVector-th product, in the order of vector instructions.
template <typename Vector, bool squared>
MOCAPRESS_INLINE float dot_of(const float* values, int size, const float* samples) {
  constexpr int kVectors = ShortFunction::kVector / kLanes<Vector, float>;
  Vector sums[kVectors] = {};
  for (int i = 0; i < size; i += ShortFunction::kVector)
    for (int v = 0; v < kVectors; ++v) {
      const int at = i + v * kLanes<Vector, float>;
      Vector value;
      Vector sample;
      load(values + at, value);
      load(samples + at, sample);
      if constexpr (squared)
        sums[v] += value * value * sample;
      else
        sums[v] += value * sample;
    }
  float parts[ShortFunction::kVector];
  for (int v = 0; v < kVectors; ++v) store(sums[v], parts + v * kLanes<Vector, float>);
  const float quarters[4] = {parts[0] + parts[4], parts[1] + parts[5], parts[2] + parts[6],
                             parts[3] + parts[7]};
  return (quarters[0] + quarters[2]) + (quarters[1] + quarters[3]);
}

template <bool squared>
float dot(const float* values, int size, const float* samples) {
  float sum = 0;
  if (!with_avx2([&]()
                     MOCAPRESS_INLINED { sum = dot_of<Floats8, squared>(values, size, samples); }))
    sum = dot_of<Floats4, squared>(values, size, samples);
  return sum;
}

}  // namespace

Synthesis::Synthesis(const Lifting& lifting) {
  // Number of coefficients at either end whose functions touch a border.
  constexpr int kBorder = 10;
  const std::vector<Band>& bands = lifting.bands();
  const auto finest = static_cast<int>(bands.size()) - 1;
  for (int b = 0; b <= finest; ++b) {
    const Band& band = bands[b];
    // Samples between coefficients.
    const int stride = 1 << std::min(finest - std::max(b, 1) + 1, 30);
    const bool has_interior = band.size > 2 * kBorder;
    Place interior{};
    for (int i = 0; i < band.size; ++i) {
      if (!has_interior || i < kBorder || i >= band.size - kBorder) {
        places_.push_back(add(lifting, band.first + i));
        continue;
      }
      if (i == kBorder) interior = add(lifting, band.first + i);
      places_.push_back({interior.first + (i - kBorder) * stride, interior.size, interior.values});
    }
  }
}

Synthesis::Place Synthesis::add(const Lifting& lifting, int coefficient) {
  constexpr double kNothing = 1e-13;
  std::vector<double> function(lifting.length(), 0.0);
  function[coefficient] = 1;
  lifting.inverse(function, function);
  const auto matters = [](double value) { return std::abs(value) > kNothing; };
  const auto first = std::ranges::find_if(function, matters);
  const auto last = std::find_if(function.rbegin(), std::make_reverse_iterator(first), matters);
  const Place place{static_cast<int>(first - function.begin()),
                    static_cast<int>(last.base() - first), std::ssize(values_)};
  values_.insert(values_.end(), first, last.base());
  return place;
}

float ShortFunction::dot(const float* samples) const {
  return mocapress::dot<false>(values_, size_, samples + first_);
}

float ShortFunction::dot_of_squares(const float* samples) const {
  return mocapress::dot<true>(values_, size_, samples + first_);
}

ShortFunctions::ShortFunctions(const Lifting& lifting) {
  const Synthesis synthesis(lifting);
  const double* last = nullptr;  // the previous function's values, which a band's functions share
  for (int c = 0; c < lifting.length(); ++c) {
    const auto& [first, values] = synthesis[c];
    const auto size = static_cast<int>(values.size());
    if (values.data() != last || places_.empty()) {
      places_.push_back({first, size, std::ssize(values_)});
      for (const double value : values) values_.push_back(static_cast<float>(value));
      while (values_.size() % ShortFunction::kVector != 0) values_.push_back(0);
    } else {
      places_.push_back({first, size, places_.back().values});
    }
    last = values.data();
  }
}

}  // namespace mocapress
