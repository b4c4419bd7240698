// SPDX-License-Identifier: MIT
#include "core/wavelet/synthesis.h"

#include <algorithm>
#include <cmath>

namespace mocapress {

Synthesis::Synthesis(const Lifting& lifting) {
  constexpr int kBorder = 10;  // coefficients whose functions feel a border, at either end
  const std::vector<Band>& bands = lifting.bands();
  const auto finest = static_cast<int>(bands.size()) - 1;
  for (int b = 0; b <= finest; ++b) {
    const Band& band = bands[static_cast<std::size_t>(b)];
    const int stride = 1 << std::min(finest - std::max(b, 1) + 1, 30);  // samples between them
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
  std::vector<double> function(static_cast<std::size_t>(lifting.length()), 0.0);
  function[static_cast<std::size_t>(coefficient)] = 1;
  lifting.inverse(function, function);
  const auto matters = [](double value) { return std::abs(value) > kNothing; };
  const auto first = std::find_if(function.begin(), function.end(), matters);
  const auto last = std::find_if(function.rbegin(), std::make_reverse_iterator(first), matters);
  const Place place{static_cast<int>(first - function.begin()),
                    static_cast<int>(last.base() - first), std::ssize(values_)};
  values_.insert(values_.end(), first, last.base());
  return place;
}

ShortFunctions::ShortFunctions(const Lifting& lifting) {
  const Synthesis synthesis(lifting);
  const double* last = nullptr;  // of the one before: those of a band have the same values
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
