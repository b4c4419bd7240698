// SPDX-License-Identifier: MIT
#include "core/wavelet/lifting.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>
#include <type_traits>

#include "core/runtime/format/interpolation.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

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

/// Calls visit(even sample, weight) for the even samples that predict odd sample `i`.
template <typename Visit>
void visit_neighbours(Basis basis, int i, int evens, const Visit& visit) {
  const runtime::Neighbours neighbours = runtime::neighbours_of(basis, i, evens);
  double weights[runtime::kMostNeighbours];
  runtime::weights_of(basis, i, neighbours, weights);
  for (int k = 0; k < neighbours.count; ++k) visit(neighbours.first + k, weights[k]);
}

// Loops over many samples are written as whole expressions, which Eigen vectorises.

template <typename Real>
auto some(Real* values, int count) {
  using Array = Eigen::Array<std::remove_const_t<Real>, Eigen::Dynamic, 1>;
  return Eigen::Map<std::conditional_t<std::is_const_v<Real>, const Array, Array>>(values, count);
}

/// The range of odd samples that are predicted with the same weights.
struct Inner {
  int first;
  int end;

  Inner(Basis basis, int evens, int odds) {
    const int reach = basis == Basis::Cubic ? 2 : 1;  // even neighbours on either side
    first = std::min(reach - 1, odds);
    end = std::clamp(evens - reach, first, odds);
  }
  int size() const { return end - first; }

  template <typename Visit>
  void visit_others(int odds, const Visit& visit) const {
    for (int i = 0; i < first; ++i) visit(i);
    for (int i = end; i < odds; ++i) visit(i);
  }
};

/// odd[i] += sign * prediction from the even samples.
template <typename Real>
void predict(Basis basis, const Real* even, int evens, Real* odd, int odds, Real sign) {
  if (basis == Basis::Haar) {
    some(odd, odds) += sign * some(even, odds);
    return;
  }
  const Inner inner(basis, evens, odds);
  inner.visit_others(odds, [&](int i) {
    double prediction = 0;
    visit_neighbours(basis, i, evens, [&](int k, double weight) {
      prediction += weight * static_cast<double>(even[k]);
    });
    odd[i] += sign * static_cast<Real>(prediction);
  });
  const runtime::InnerWeights weights = runtime::inner_weights(basis);
  const Real near = sign * static_cast<Real>(weights.near);
  const Real far = sign * static_cast<Real>(weights.far);
  const Real* const e = even + inner.first;
  auto predicted = some(odd + inner.first, inner.size());
  if (basis == Basis::Cubic)
    predicted += near * (some(e, inner.size()) + some(e + 1, inner.size())) +
                 far * (some(e - 1, inner.size()) + some(e + 2, inner.size()));
  else
    predicted += near * (some(e, inner.size()) + some(e + 1, inner.size()));
}

/// even[i] += sign * a quarter of the details on either side, mirrored at the borders. (Haar: half
/// of the detail after it, which makes it the mean.) Keeps the mean of the signal in the coarse
/// samples.
template <typename Real>
void update(Basis basis, Real* even, int evens, const Real* detail, int details, Real sign) {
  if (basis == Basis::Haar) {
    some(even, details) += sign * Real(0.5) * some(detail, details);
    return;
  }
  const Real quarter = sign * Real(0.25);
  even[0] += quarter * 2 * detail[0];
  some(even + 1, details - 1) +=
      quarter * (some(detail, details - 1) + some(detail + 1, details - 1));
  if (evens > details) even[evens - 1] += quarter * 2 * detail[details - 1];
}

/// even += the transpose of predict() with +1, applied to the odd samples. `around` is memory for 4
/// more values than there are even samples.
template <typename Real>
void predict_transposed(Basis basis, const Real* odd, int odds, Real* even, int evens,
                        Real* around) {
  if (basis == Basis::Haar) {
    some(even, odds) += some(odd, odds);
    return;
  }
  // Pads the inner odd samples with zeros, so that each even sample sums its neighbours'
  // contributions.
  const Inner inner(basis, evens, odds);
  std::fill_n(around, evens + 4, Real(0));
  std::copy(odd + inner.first, odd + inner.end, around + 2 + inner.first);
  const runtime::InnerWeights weights = runtime::inner_weights(basis);
  const auto near = static_cast<Real>(weights.near);
  const auto far = static_cast<Real>(weights.far);
  if (basis == Basis::Cubic)
    some(even, evens) += near * (some(around + 1, evens) + some(around + 2, evens)) +
                         far * (some(around, evens) + some(around + 3, evens));
  else
    some(even, evens) += near * (some(around + 1, evens) + some(around + 2, evens));
  inner.visit_others(odds, [&](int i) {
    visit_neighbours(basis, i, evens,
                     [&](int k, double weight) { even[k] += static_cast<Real>(weight) * odd[i]; });
  });
}

/// detail += the transpose of update() with -1, applied to the even samples.
template <typename Real>
void update_transposed(Basis basis, const Real* even, int evens, Real* detail, int details) {
  if (basis == Basis::Haar) {
    some(detail, details) -= Real(0.5) * some(even, details);
    return;
  }
  const int last = details - 1;
  detail[0] -= Real(0.5) * even[0];
  if (last > 0) {
    detail[0] -= Real(0.25) * even[1];
    some(detail + 1, last - 1) -=
        Real(0.25) * (some(even + 1, last - 1) + some(even + 2, last - 1));
    detail[last] -= Real(0.25) * even[last];
  }
  if (evens > details) detail[last] -= Real(0.5) * even[evens - 1];
}

#ifdef __SSE2__
int split_in_vectors(const float* signal, int odds, float* even, float* odd) {
  int i = 0;
  for (; i + 4 <= odds; i += 4) {
    const __m128 a = _mm_loadu_ps(signal + 2 * i);
    const __m128 b = _mm_loadu_ps(signal + 2 * i + 4);
    _mm_storeu_ps(even + i, _mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)));
    _mm_storeu_ps(odd + i, _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
  }
  return i;
}
int merge_in_vectors(const float* even, const float* odd, int odds, float* signal) {
  int i = 0;
  for (; i + 4 <= odds; i += 4) {
    const __m128 e = _mm_loadu_ps(even + i);
    const __m128 o = _mm_loadu_ps(odd + i);
    _mm_storeu_ps(signal + 2 * i, _mm_unpacklo_ps(e, o));
    _mm_storeu_ps(signal + 2 * i + 4, _mm_unpackhi_ps(e, o));
  }
  return i;
}
#else
int split_in_vectors(const float*, int, float*, float*) {
  return 0;
}
int merge_in_vectors(const float*, const float*, int, float*) {
  return 0;
}
#endif
int split_in_vectors(const double*, int, double*, double*) {
  return 0;
}
int merge_in_vectors(const double*, const double*, int, double*) {
  return 0;
}

template <typename Real>
void split(const Real* signal, int length, Real* even, Real* odd) {
  const int odds = odds_in(length);
  for (int i = split_in_vectors(signal, odds, even, odd); i < odds; ++i) {
    even[i] = signal[2 * i];
    odd[i] = signal[2 * i + 1];
  }
  if (evens_in(length) > odds) even[odds] = signal[length - 1];
}

template <typename Real>
void merge(const Real* even, const Real* odd, int length, Real* signal) {
  const int odds = odds_in(length);
  for (int i = merge_in_vectors(even, odd, odds, signal); i < odds; ++i) {
    signal[2 * i] = even[i];
    signal[2 * i + 1] = odd[i];
  }
  if (evens_in(length) > odds) signal[length - 1] = even[odds];
}

template <typename Real>
std::unique_ptr<Real[]> memory_for(int count) {
  return std::make_unique_for_overwrite<Real[]>(static_cast<std::size_t>(count));
}

/// Splits a signal level by level. `details` turns each level's even and odd samples into coarser
/// samples and details.
template <typename Real, typename Details>
void take_apart(const std::vector<int>& lengths, std::span<const Real> samples,
                std::span<Real> coefficients, const Details& details) {
  const auto length = static_cast<int>(samples.size());
  auto signal = memory_for<Real>(length);
  auto even = memory_for<Real>(evens_in(length));
  std::ranges::copy(samples, signal.get());
  for (const int rest : lengths) {
    Real* const odd = coefficients.data() + evens_in(rest);
    split(signal.get(), rest, even.get(), odd);
    details(even.get(), evens_in(rest), odd, odds_in(rest));
    signal.swap(even);
  }
  const int coarse = lengths.empty() ? length : evens_in(lengths.back());
  std::copy_n(signal.get(), coarse, coefficients.begin());
}

template <typename Real>
void forward_of(Basis basis, const std::vector<int>& lengths, std::span<const Real> samples,
                std::span<Real> coefficients) {
  take_apart(lengths, samples, coefficients, [&](Real* even, int evens, Real* odd, int odds) {
    predict(basis, even, evens, odd, odds, Real(-1));
    update(basis, even, evens, odd, odds, Real(1));
  });
}

template <typename Real>
void correlate_of(Basis basis, const std::vector<int>& lengths, std::span<const Real> samples,
                  std::span<Real> products) {
  const auto around = memory_for<Real>(evens_in(static_cast<int>(samples.size())) + 4);
  take_apart(lengths, samples, products, [&](Real* even, int evens, Real* odd, int odds) {
    predict_transposed(basis, odd, odds, even, evens, around.get());
    update_transposed(basis, even, evens, odd, odds);
  });
}

template <typename Real>
void inverse_of(Basis basis, const std::vector<int>& lengths, std::span<const Real> coefficients,
                std::span<Real> samples) {
  const auto length = static_cast<int>(samples.size());
  if (lengths.empty()) {
    if (samples.data() != coefficients.data()) std::ranges::copy(coefficients, samples.begin());
    return;
  }
  auto even = memory_for<Real>(evens_in(length));
  auto next = memory_for<Real>(evens_in(length));
  const auto odd = memory_for<Real>(odds_in(length));
  std::copy_n(coefficients.begin(), evens_in(lengths.back()), even.get());
  for (auto whole = lengths.rbegin(); whole != lengths.rend(); ++whole) {
    const int evens = evens_in(*whole);
    const int odds = odds_in(*whole);
    std::copy_n(coefficients.begin() + evens, odds, odd.get());
    update(basis, even.get(), evens, odd.get(), odds, Real(-1));
    predict(basis, even.get(), evens, odd.get(), odds, Real(1));
    const bool is_last = std::next(whole) == lengths.rend();
    merge(even.get(), odd.get(), *whole, is_last ? samples.data() : next.get());
    even.swap(next);
  }
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
  std::ranges::reverse(bands_);
}

void Lifting::forward(std::span<const double> samples, std::span<double> coefficients) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  forward_of(basis_, lengths_, samples, coefficients);
}

void Lifting::forward(std::span<const float> samples, std::span<float> coefficients) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  forward_of(basis_, lengths_, samples, coefficients);
}

void Lifting::inverse(std::span<const double> coefficients, std::span<double> samples) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  inverse_of(basis_, lengths_, coefficients, samples);
}

void Lifting::inverse(std::span<const float> coefficients, std::span<float> samples) const {
  assert(std::ssize(samples) == length_ && std::ssize(coefficients) == length_);
  inverse_of(basis_, lengths_, coefficients, samples);
}

void Lifting::correlate(std::span<const double> samples, std::span<double> products) const {
  assert(std::ssize(samples) == length_ && std::ssize(products) == length_);
  correlate_of(basis_, lengths_, samples, products);
}

void Lifting::correlate(std::span<const float> samples, std::span<float> products) const {
  assert(std::ssize(samples) == length_ && std::ssize(products) == length_);
  correlate_of(basis_, lengths_, samples, products);
}

double Lifting::norm(int coefficient) const {
  std::vector<double> function(length_, 0.0);
  function[coefficient] = 1;
  inverse(function, function);
  double squares = 0;
  for (const double value : function) squares += value * value;
  return std::sqrt(squares);
}

std::vector<double> Lifting::norms_of_band(const Band& band) const {
  // Away from the borders the functions of a band are shifts of one another, so one is computed for
  // all.
  constexpr int kBorder = 10;
  std::vector<double> norms(band.size);
  const bool has_interior = band.size > 2 * kBorder;
  const double interior = has_interior ? norm(band.first + band.size / 2) : 0;
  for (int i = 0; i < band.size; ++i) {
    const bool inside = has_interior && i >= kBorder && i < band.size - kBorder;
    norms[i] = inside ? interior : norm(band.first + i);
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
    gains.insert(gains.end(), static_cast<std::size_t>(bands_[b].size), std::exp2(0.5 * depth));
  }
  return gains;
}

}  // namespace mocapress
