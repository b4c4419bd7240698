// SPDX-License-Identifier: MIT
#include "core/wavelet/lifting.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/codec/format/interpolation.h"

namespace mocapress {

std::string_view name(Basis basis) {
  switch (basis) {
    case Basis::Haar:
      return "haar";
    case Basis::Linear:
      return "linear";
    case Basis::Cubic:
      return "cubic";
  }
  return "unknown";
}

namespace {

constexpr int kCoarsest = 4;  // a signal shorter than this is not split further

int evens_in(int length) {
  return (length + 1) / 2;
}
int odds_in(int length) {
  return length / 2;
}

/// Calls visit(even sample, weight) for those that predict odd sample `i`.
template <typename Visit>
void visit_neighbours(Basis basis, int i, int evens, const Visit& visit) {
  const auto wavelet = static_cast<runtime::Wavelet>(basis);
  const runtime::Neighbours neighbours = runtime::neighbours_of(wavelet, i, evens);
  double weights[runtime::kMostNeighbours];
  runtime::weights_of(wavelet, i, neighbours, weights);
  for (int k = 0; k < neighbours.count; ++k) visit(neighbours.first + k, weights[k]);
}

/// odd[i] += sign * prediction from the even samples.
void predict(Basis basis, const double* even, int evens, double* odd, int odds, double sign) {
  if (basis == Basis::Haar) {
    for (int i = 0; i < odds; ++i) odd[i] += sign * even[i];
    return;
  }
  const int reach = basis == Basis::Cubic ? 2 : 1;  // even neighbours on either side
  const int inner_first = std::min(reach - 1, odds);
  const int inner_last = std::clamp(evens - reach, inner_first, odds);
  const auto border = [&](int i) {
    double prediction = 0;
    visit_neighbours(basis, i, evens,
                     [&](int k, double weight) { prediction += weight * even[k]; });
    odd[i] += sign * prediction;
  };
  for (int i = 0; i < inner_first; ++i) border(i);
  const runtime::InnerWeights inner = runtime::inner_weights(static_cast<runtime::Wavelet>(basis));
  const double near = sign * inner.near;
  const double far = sign * inner.far;
  if (basis == Basis::Cubic) {
    for (int i = inner_first; i < inner_last; ++i)
      odd[i] += near * (even[i] + even[i + 1]) + far * (even[i - 1] + even[i + 2]);
  } else {
    for (int i = inner_first; i < inner_last; ++i) odd[i] += near * (even[i] + even[i + 1]);
  }
  for (int i = inner_last; i < odds; ++i) border(i);
}

/// even[i] += sign * a quarter of the details on either side, mirrored at the borders. (Haar: half
/// of the one after it, which makes it the mean.) Keeps the mean of the signal in the coarse
/// samples.
void update(Basis basis, double* even, int evens, const double* detail, int details, double sign) {
  if (basis == Basis::Haar) {
    for (int i = 0; i < details; ++i) even[i] += sign * 0.5 * detail[i];
    return;
  }
  const double quarter = sign * 0.25;
  even[0] += quarter * 2 * detail[0];
  for (int i = 1; i < details; ++i) even[i] += quarter * (detail[i - 1] + detail[i]);
  if (evens > details) even[evens - 1] += quarter * 2 * detail[details - 1];
}

/// even += the transpose of predict() with +1, of the odd samples.
void predict_transposed(Basis basis, const double* odd, int odds, double* even, int evens) {
  if (basis == Basis::Haar) {
    for (int i = 0; i < odds; ++i) even[i] += odd[i];
    return;
  }
  const int reach = basis == Basis::Cubic ? 2 : 1;
  const int inner_first = std::min(reach - 1, odds);
  const int inner_last = std::clamp(evens - reach, inner_first, odds);
  const auto border = [&](int i) {
    visit_neighbours(basis, i, evens, [&](int k, double weight) { even[k] += weight * odd[i]; });
  };
  for (int i = 0; i < inner_first; ++i) border(i);
  const auto [near, far] = runtime::inner_weights(static_cast<runtime::Wavelet>(basis));
  for (int i = inner_first; i < inner_last; ++i) {
    even[i] += near * odd[i];
    even[i + 1] += near * odd[i];
    if (basis == Basis::Linear) continue;
    even[i - 1] += far * odd[i];
    even[i + 2] += far * odd[i];
  }
  for (int i = inner_last; i < odds; ++i) border(i);
}

/// detail += the transpose of update() with -1, of the even samples.
void update_transposed(Basis basis, const double* even, int evens, double* detail, int details) {
  if (basis == Basis::Haar) {
    for (int i = 0; i < details; ++i) detail[i] -= 0.5 * even[i];
    return;
  }
  detail[0] -= 0.5 * even[0];
  for (int i = 1; i < details; ++i) {
    detail[i - 1] -= 0.25 * even[i];
    detail[i] -= 0.25 * even[i];
  }
  if (evens > details) detail[details - 1] -= 0.5 * even[evens - 1];
}

}  // namespace

Lifting::Lifting(Basis basis, int length) : basis_(basis), length_(length) {
  assert(length >= 0);
  for (int rest = length; rest >= kCoarsest; rest = evens_in(rest)) {
    lengths_.push_back(rest);
    bands_.push_back({evens_in(rest), odds_in(rest)});
  }
  const int coarse = lengths_.empty() ? length : evens_in(lengths_.back());
  bands_.push_back({0, coarse});
  std::reverse(bands_.begin(), bands_.end());
}

void Lifting::forward(std::span<const double> samples, std::span<double> coefficients) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  if (samples.data() != coefficients.data())
    std::copy(samples.begin(), samples.end(), coefficients.begin());
  std::vector<double> even(static_cast<std::size_t>(evens_in(length_)));
  std::vector<double> odd(static_cast<std::size_t>(odds_in(length_)));
  for (const int length : lengths_) {
    const int evens = evens_in(length);
    const int odds = odds_in(length);
    double* const signal = coefficients.data();
    for (int i = 0; i < odds; ++i) {
      even[static_cast<std::size_t>(i)] = signal[2 * i];
      odd[static_cast<std::size_t>(i)] = signal[2 * i + 1];
    }
    if (evens > odds) even[static_cast<std::size_t>(odds)] = signal[length - 1];
    predict(basis_, even.data(), evens, odd.data(), odds, -1);
    update(basis_, even.data(), evens, odd.data(), odds, +1);
    std::copy_n(even.data(), evens, signal);
    std::copy_n(odd.data(), odds, signal + evens);
  }
}

void Lifting::inverse(std::span<const double> coefficients, std::span<double> samples) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  if (samples.data() != coefficients.data())
    std::copy(coefficients.begin(), coefficients.end(), samples.begin());
  std::vector<double> even(static_cast<std::size_t>(evens_in(length_)));
  std::vector<double> odd(static_cast<std::size_t>(odds_in(length_)));
  for (auto length = lengths_.rbegin(); length != lengths_.rend(); ++length) {
    const int evens = evens_in(*length);
    const int odds = odds_in(*length);
    double* const signal = samples.data();
    std::copy_n(signal, evens, even.data());
    std::copy_n(signal + evens, odds, odd.data());
    update(basis_, even.data(), evens, odd.data(), odds, -1);
    predict(basis_, even.data(), evens, odd.data(), odds, +1);
    for (int i = 0; i < odds; ++i) {
      signal[2 * i] = even[static_cast<std::size_t>(i)];
      signal[2 * i + 1] = odd[static_cast<std::size_t>(i)];
    }
    if (evens > odds) signal[*length - 1] = even[static_cast<std::size_t>(odds)];
  }
}

void Lifting::correlate(std::span<const double> samples, std::span<double> products) const {
  assert(std::ssize(samples) == length_ && std::ssize(products) == length_);
  if (samples.data() != products.data())
    std::copy(samples.begin(), samples.end(), products.begin());
  std::vector<double> even(static_cast<std::size_t>(evens_in(length_)));
  std::vector<double> odd(static_cast<std::size_t>(odds_in(length_)));
  for (const int length : lengths_) {
    const int evens = evens_in(length);
    const int odds = odds_in(length);
    double* const signal = products.data();
    for (int i = 0; i < odds; ++i) {
      even[static_cast<std::size_t>(i)] = signal[2 * i];
      odd[static_cast<std::size_t>(i)] = signal[2 * i + 1];
    }
    if (evens > odds) even[static_cast<std::size_t>(odds)] = signal[length - 1];
    predict_transposed(basis_, odd.data(), odds, even.data(), evens);
    update_transposed(basis_, even.data(), evens, odd.data(), odds);
    std::copy_n(even.data(), evens, signal);
    std::copy_n(odd.data(), odds, signal + evens);
  }
}

double Lifting::norm(int coefficient) const {
  std::vector<double> function(static_cast<std::size_t>(length_), 0.0);
  function[static_cast<std::size_t>(coefficient)] = 1;
  inverse(function, function);
  double squares = 0;
  for (const double value : function) squares += value * value;
  return std::sqrt(squares);
}

std::vector<double> Lifting::norms_of_band(const Band& band) const {
  // Away from the borders the functions of a band are shifts of one another: one stands for all.
  constexpr int kBorder = 10;
  std::vector<double> norms(static_cast<std::size_t>(band.size));
  const bool has_interior = band.size > 2 * kBorder;
  const double interior = has_interior ? norm(band.first + band.size / 2) : 0;
  for (int i = 0; i < band.size; ++i) {
    const bool inside = has_interior && i >= kBorder && i < band.size - kBorder;
    norms[static_cast<std::size_t>(i)] = inside ? interior : norm(band.first + i);
  }
  return norms;
}

std::vector<double> Lifting::norms() const {
  std::vector<double> all;
  for (const Band& band : bands_) {
    const std::vector<double> norms = norms_of_band(band);
    all.insert(all.end(), norms.begin(), norms.end());
  }
  return all;
}

std::vector<double> Lifting::gains() const {
  std::vector<double> gains;
  const auto finest = static_cast<int>(bands_.size()) - 1;
  for (int b = 0; b <= finest; ++b) {
    const int depth = finest == 0 ? 0 : finest - std::max(b, 1) + 1;
    gains.insert(gains.end(), static_cast<std::size_t>(bands_[static_cast<std::size_t>(b)].size),
                 std::exp2(0.5 * depth));
  }
  return gains;
}

}  // namespace mocapress
