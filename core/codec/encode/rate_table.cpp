// SPDX-License-Identifier: MIT
#include "core/codec/encode/rate_table.h"

#include <algorithm>
#include <array>

#include "core/codec/format/adaptive.h"

namespace mocapress {
namespace {

constexpr int kMagnitudes = 16;  // the last stands for all above

using BitsOfMagnitudes = std::array<double, kMagnitudes>;
using Table = std::array<std::array<BitsOfMagnitudes, kSizes>, kSizes>;

/// By size_of() those before and above.
Table make_table() {
  Table table{};
  for (int before = 0; before < kSizes; ++before)
    for (int above = 0; above < kSizes; ++above) {
      const double mean = 0.02 + 0.2 * before + 0.15 * above;
      const double ratio = mean / (1 + mean);
      for (int m = 0; m < kMagnitudes; ++m)
        table[static_cast<std::size_t>(before)][static_cast<std::size_t>(above)]
             [static_cast<std::size_t>(m)] =
                 (m > 0 ? 1 : 0) - std::log2((1 - ratio) * std::pow(ratio, m));
    }
  return table;
}

const Table kBits = make_table();

}  // namespace

double RateTable::bits(const int* signal, int b, int i, int value) const {
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
  const BitsOfMagnitudes& of =
      kBits[static_cast<std::size_t>(size_of(before))][static_cast<std::size_t>(size_of(above))];
  const int magnitude = std::abs(value);
  if (magnitude < kMagnitudes - 1) return of[static_cast<std::size_t>(magnitude)];
  return of[kMagnitudes - 1] + 2 * std::log2(magnitude - kMagnitudes + 2.0);
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

}  // namespace mocapress
