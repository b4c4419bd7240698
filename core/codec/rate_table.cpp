// SPDX-License-Identifier: MIT
#include "core/codec/rate_table.h"

#include <algorithm>

#include "core/codec/coefficient_model.h"

namespace mocapress {
namespace {

constexpr int kContexts = kLevels * kSizes * kSizes;
constexpr int kMagnitudes = 16;  // the last stands for all above

}  // namespace

RateTable::RateTable(const std::vector<Band>& bands)
    : bands_(bands), bits_(static_cast<std::size_t>(kContexts * kMagnitudes), 0) {}

int RateTable::context(const int* signal, int b, int i) const {
  const int* const own = signal + bands_[static_cast<std::size_t>(b)].first;
  const int before = 2 * (i > 0 ? std::abs(own[i - 1]) : 0) + (i > 1 ? std::abs(own[i - 2]) : 0);
  int above = 0;
  if (b > 1) {
    const Band& upper = bands_[static_cast<std::size_t>(b - 1)];
    const int k = i / 2;
    const int l = i % 2 != 0 ? k + 1 : k - 1;
    if (k < upper.size) above += 2 * std::abs(signal[upper.first + k]);
    if (l >= 0 && l < upper.size) above += std::abs(signal[upper.first + l]);
  }
  const int level = std::min(static_cast<int>(bands_.size()) - 1 - b, kLevels - 1);
  return (level * kSizes + size_of(before)) * kSizes + size_of(above);
}

double RateTable::bits_in(int context, int value) const {
  const int magnitude = std::abs(value);
  const double* const row = bits_.data() + static_cast<std::ptrdiff_t>(context) * kMagnitudes;
  if (magnitude < kMagnitudes - 1) return row[magnitude];
  return row[kMagnitudes - 1] + 2 * std::log2(magnitude - kMagnitudes + 2.0);
}

bool RateTable::is_zero(const int* signal, const Band& band) const {
  return std::all_of(signal + band.first, signal + band.first + band.size,
                     [](int value) { return value == 0; });
}

double RateTable::bits_around(int* signal, int b, int i, int value) const {
  const Band& band = bands_[static_cast<std::size_t>(b)];
  int& mine = signal[band.first + i];
  const int kept = mine;
  mine = value;
  double sum = bits(signal, b, i, value);
  for (int k = i + 1; k <= i + 2 && k < band.size; ++k)
    sum += bits(signal, b, k, signal[band.first + k]);
  if (static_cast<std::size_t>(b) + 1 < bands_.size()) {
    const Band& lower = bands_[static_cast<std::size_t>(b) + 1];
    for (int k = std::max(2 * i - 1, 0); k <= 2 * i + 2 && k < lower.size; ++k)
      sum += bits(signal, b + 1, k, signal[lower.first + k]);
  }
  mine = kept;
  return sum;
}

double RateTable::bits(const int* signal) const {
  double sum = 0;
  for (int i = 0; i < bands_[0].size; ++i)
    sum += coarse_bits(signal[i] - (i > 0 ? signal[i - 1] : 0));
  for (int b = 1; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    if (is_zero(signal, band)) continue;
    for (int i = 0; i < band.size; ++i) sum += bits(signal, b, i, signal[band.first + i]);
  }
  return sum;
}

void RateTable::learn(const Eigen::MatrixXi& values) {
  std::vector<double> counts(bits_.size(), 0);
  for (Eigen::Index s = 0; s < values.cols(); ++s) {
    const int* const signal = values.col(s).data();
    for (int b = 1; b < static_cast<int>(bands_.size()); ++b) {
      const Band& band = bands_[static_cast<std::size_t>(b)];
      if (is_zero(signal, band)) continue;
      for (int i = 0; i < band.size; ++i) {
        const int magnitude = std::min(std::abs(signal[band.first + i]), kMagnitudes - 1);
        counts[static_cast<std::size_t>(context(signal, b, i) * kMagnitudes + magnitude)] += 1;
      }
    }
  }
  for (int c = 0; c < kContexts; ++c) {
    // What was seen little leans on a geometric law that follows the neighbours.
    constexpr double kTrust = 4;
    const double mean = 0.02 + 0.2 * (c / kSizes % kSizes) + 0.15 * (c % kSizes);
    const double ratio = mean / (1 + mean);
    double* const row = bits_.data() + static_cast<std::ptrdiff_t>(c) * kMagnitudes;
    double total = 0;
    for (int m = 0; m < kMagnitudes; ++m) {
      row[m] = counts[static_cast<std::size_t>(c * kMagnitudes + m)] + 0.002 +
               kTrust * (1 - ratio) * std::pow(ratio, m);
      total += row[m];
    }
    for (int m = 0; m < kMagnitudes; ++m) row[m] = std::log2(total / row[m]) + (m > 0 ? 1 : 0);
  }
}

}  // namespace mocapress
