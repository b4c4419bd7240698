// SPDX-License-Identifier: MIT
#include "core/codec/encode/search/size_estimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace mocapress {
namespace {

constexpr int kCountedMagnitudes = 16;  // the last one stands for all larger ones
constexpr int kCountedLevels = 3;       // the finest band, the next, and all others
constexpr int kExpectedClasses = 13;    // of the sum around a coefficient, by half octave

using Counts =
    std::array<std::array<std::array<int, kCountedMagnitudes>, kExpectedClasses>, kCountedLevels>;

/// Maps sums to classes: small sums by themselves, larger ones by half octave from 4 on.
constexpr int kCountedSums = 64;  // all larger sums are of the last class
const std::array<std::uint8_t, kCountedSums> kClassOf = [] {
  std::array<std::uint8_t, kCountedSums> classes{};
  for (int sum = 0; sum < kCountedSums; ++sum)
    classes[sum] = static_cast<std::uint8_t>(
        sum < 4 ? sum : std::min(static_cast<int>(2 * std::log2(sum)), kExpectedClasses - 1));
  return classes;
}();

/// The magnitudes of one band for all signals. Each signal's are padded with zeros.
class BandMagnitudes {
 public:
  void read(const QuantisedSignals& coded, const runtime::Band& band) {
    size_ = band.size;
    stride_ = band.size + 2 * kZeros;
    bytes_.assign(stride_ * coded.signal_count(), 0);
    significant_.assign(coded.signal_count(), 0);
    for (int s = 0; s < coded.signal_count(); ++s) {
      const int* const values = coded.values.col(s).data() + band.first;
      std::uint8_t* const to = bytes_.data() + s * stride_ + kZeros;
      int any = 0;
      for (int i = 0; i < band.size; ++i) {
        any |= values[i];
        to[i] = static_cast<std::uint8_t>(std::min(std::abs(values[i]), 255));
      }
      significant_[s] = any != 0 ? 1 : 0;
    }
  }
  int size() const { return size_; }
  bool is_significant(int s) const { return significant_[s] != 0; }
  const std::uint8_t* of(int s) const { return bytes_.data() + s * stride_ + kZeros; }

 private:
  static constexpr std::ptrdiff_t kZeros = 4;
  int size_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint8_t> significant_;
};

/// The logarithm of the gamma function, by Stirling's series. Requires x > 0.
double log_gamma(double x) {
  double factors = 1;
  for (; x < 6; ++x) factors *= x;
  return (x - 0.5) * std::log(x) - x + 0.5 * std::log(2 * std::numbers::pi) + 1 / (12 * x) -
         std::log(factors);
}

/// Estimates the bits of `counts` of each magnitude when coded with adaptive probabilities that
/// start as a geometric distribution with this mean.
double adaptive_bits(const std::array<int, kCountedMagnitudes>& counts, double mean) {
  constexpr double kTrust = 20;  // observations that the distribution counts for
  constexpr double kLeast = 1e-6;
  const double ratio = mean / (1 + mean);
  double all = 0;
  double nats = 0;
  double rest = 1;
  double odds = 1 - ratio;
  for (int m = 0; m < kCountedMagnitudes; ++m, odds *= ratio) {
    const double share = m + 1 < kCountedMagnitudes ? odds : std::max(rest, kLeast);
    rest -= odds;
    const double count = counts[m];
    all += count;
    if (count > 0) nats -= log_gamma(kTrust * share + count) - log_gamma(kTrust * share);
  }
  if (all > 0) nats += log_gamma(kTrust + all) - log_gamma(kTrust);
  return nats / std::numbers::ln2;
}

/// Sums the weighted magnitudes around each coefficient of a signal in a band.
void find_sums(const BandMagnitudes& band, const BandMagnitudes& above, bool has_parents, int s,
               const SignalNeighbours& neighbours, std::vector<std::uint16_t>& sums) {
  const int size = band.size();
  const std::uint8_t* const own = band.of(s);
  for (int i = 0; i < size; ++i) sums[i] = static_cast<std::uint16_t>(2 * own[i - 1] + own[i - 2]);
  if (has_parents) {
    const std::uint8_t* const upper = above.of(s);
    for (int i = 0; i < size; i += 2)
      sums[i] += static_cast<std::uint16_t>(2 * upper[i / 2] + upper[i / 2 - 1]);
    for (int i = 1; i < size; i += 2)
      sums[i] += static_cast<std::uint16_t>(2 * upper[i / 2] + upper[i / 2 + 1]);
  }
  if (neighbours.sibling >= 0 && band.is_significant(neighbours.sibling)) {
    const std::uint8_t* const sibling = band.of(neighbours.sibling);
    for (int i = 0; i < size; ++i)
      sums[i] +=
          static_cast<std::uint16_t>(2 * sibling[i] + (sibling[i - 1] + sibling[i + 1] + 1) / 2);
  }
  if (neighbours.mirror >= 0 && band.is_significant(neighbours.mirror)) {
    const std::uint8_t* const mirror = band.of(neighbours.mirror);
    for (int i = 0; i < size; ++i) sums[i] += mirror[i];
  }
}

double mean_of_class(int expected) {
  return 0.02 + 0.1 * (expected < 4 ? expected : std::exp2(0.5 * expected + 0.25));
}

}  // namespace

SizeParts size_parts(const QuantisedSignals& coded,
                     const std::vector<SignalNeighbours>& neighbours) {
  SizeParts bits;
  const runtime::Bands bands(static_cast<int>(coded.values.rows()));
  bits.signals = 8 * coded.signal_count();
  for (int s = 0; s < coded.signal_count(); ++s) {
    int before = 0;
    for (int i = 0; i < bands[0].size; ++i) {
      const double difference = coded.values(i, s) - static_cast<double>(before);
      bits.coarse += 1 + 2 * std::log2(1 + 2 * std::abs(difference));
      before = coded.values(i, s);
    }
  }
  Counts counts{};
  BandMagnitudes band;
  BandMagnitudes above;
  std::vector<std::uint16_t> sums(coded.values.rows());
  for (int b = 1; b < bands.count; ++b) {
    std::swap(band, above);
    band.read(coded, bands[b]);
    auto& of_level = counts[std::min(bands.count - 1 - b, kCountedLevels - 1)];
    for (int s = 0; s < coded.signal_count(); ++s) {
      if (!band.is_significant(s)) continue;
      ++bits.bands;
      find_sums(band, above, b > 1, s, neighbours[s], sums);
      const std::uint8_t* const own = band.of(s);
      for (int i = 0; i < bands[b].size; ++i) {
        const int sum = std::min<int>(sums[i], kCountedSums - 1);
        ++of_level[kClassOf[sum]][std::min<std::size_t>(own[i], kCountedMagnitudes - 1)];
        if (own[i] >= kCountedMagnitudes - 1)
          bits.details += 2 * std::log2(std::abs(coded.values(bands[b].first + i, s)) -
                                        kCountedMagnitudes + 3.0);
      }
    }
  }
  for (const auto& of_level : counts)
    for (int e = 0; e < kExpectedClasses; ++e) {
      const auto& of_class = of_level[e];
      bits.details += adaptive_bits(of_class, mean_of_class(e));
      for (std::size_t m = 1; m < of_class.size(); ++m) bits.signs += of_class[m];
    }
  return {bits.details / 8, bits.signs / 8, bits.coarse / 8, bits.bands / 8, bits.signals / 8};
}

std::size_t estimated_bytes(const QuantisedSignals& coded,
                            const std::vector<SignalNeighbours>& neighbours) {
  const SizeParts parts = size_parts(coded, neighbours);
  // Factors fitted on corpus/train by: mocapress-draft-study CORPUS/train fit.
  const double bytes = 0.6894 * parts.details + 1.3928 * parts.signs + 0.7343 * parts.coarse +
                       1.6141 * parts.bands + 0.3191 * parts.signals;
  return static_cast<std::size_t>(std::lround(std::max(bytes, 1.0)));
}

}  // namespace mocapress
