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

double bits_of(int magnitude, int before, int above) {
  const BitsOfMagnitudes& of =
      kBits[static_cast<std::size_t>(size_of(before))][static_cast<std::size_t>(size_of(above))];
  if (magnitude < kMagnitudes - 1) return of[static_cast<std::size_t>(magnitude)];
  return of[kMagnitudes - 1] + 2 * std::log2(magnitude - kMagnitudes + 2.0);
}

}  // namespace

RateTable::Neighbours RateTable::neighbours_of(const int* signal, int b, int i) const {
  const int* const own = signal + bands_[static_cast<std::size_t>(b)].first;
  Neighbours found;
  found.before = 2 * (i > 0 ? std::abs(own[i - 1]) : 0) + (i > 1 ? std::abs(own[i - 2]) : 0);
  if (b > 1) {
    const Band& upper = bands_[static_cast<std::size_t>(b - 1)];
    const int k = i / 2;
    const int l = i % 2 != 0 ? k + 1 : k - 1;
    if (k < upper.size) found.above += 2 * std::abs(signal[upper.first + k]);
    if (l >= 0 && l < upper.size) found.above += std::abs(signal[upper.first + l]);
  }
  return found;
}

double RateTable::bits(const int* signal, int b, int i, int value) const {
  const auto [before, above] = neighbours_of(signal, b, i);
  return bits_of(std::abs(value), before, above);
}

bool RateTable::is_zero(const int* signal, const Band& band) const {
  return std::all_of(signal + band.first, signal + band.first + band.size,
                     [](int value) { return value == 0; });
}

RateTable::Around::Around(const RateTable& table, const int* signal, int b, int i) {
  const std::vector<Band>& bands = table.bands_;
  const Band& band = bands[static_cast<std::size_t>(b)];
  const auto [before, above] = table.neighbours_of(signal, b, i);
  before_ = before;
  above_ = above;
  const int mine = std::abs(signal[band.first + i]);
  const auto follow = [&](int other_band, int k, int share_of_before, int share_of_above) {
    const auto found = table.neighbours_of(signal, other_band, k);
    followers_[static_cast<std::size_t>(count_++)] = {
        std::abs(signal[bands[static_cast<std::size_t>(other_band)].first + k]),
        found.before - share_of_before * mine, found.above - share_of_above * mine, share_of_before,
        share_of_above};
  };
  for (int k = i + 1; k <= i + 2 && k < band.size; ++k) follow(b, k, k == i + 1 ? 2 : 1, 0);
  if (static_cast<std::size_t>(b) + 1 < bands.size()) {
    const Band& lower = bands[static_cast<std::size_t>(b) + 1];
    for (int k = std::max(2 * i - 1, 0); k <= 2 * i + 2 && k < lower.size; ++k)
      follow(b + 1, k, 0, k / 2 == i ? 2 : 1);
  }
}

double RateTable::Around::bits(int value) const {
  const int magnitude = std::abs(value);
  double sum = bits_of(magnitude, before_, above_);
  for (int f = 0; f < count_; ++f) {
    const Follower& follower = followers_[static_cast<std::size_t>(f)];
    sum += bits_of(follower.magnitude, follower.before + follower.share_of_before * magnitude,
                   follower.above + follower.share_of_above * magnitude);
  }
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
