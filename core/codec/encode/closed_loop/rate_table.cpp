// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/rate_table.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "core/codec/format/adaptive.h"

namespace mocapress {
namespace {

constexpr int kMagnitudes = 16;  // the last one stands for all larger ones

using BitsOfMagnitudes = std::array<double, kMagnitudes>;
using Table = std::array<std::array<BitsOfMagnitudes, kSizes>, kSizes>;

/// Indexed by size_of() of the coefficients before and above.
Table make_table() {
  Table table{};
  for (int before = 0; before < kSizes; ++before)
    for (int above = 0; above < kSizes; ++above) {
      const double mean = 0.02 + 0.2 * before + 0.15 * above;
      const double ratio = mean / (1 + mean);
      for (int m = 0; m < kMagnitudes; ++m)
        table[before][above][m] = (m > 0 ? 1 : 0) - std::log2((1 - ratio) * std::pow(ratio, m));
    }
  return table;
}

const Table kBits = make_table();

constexpr std::size_t kSums = 64;  // size_of() is the same for all larger sums
const std::array<std::uint8_t, kSums> kSizeOf = [] {
  std::array<std::uint8_t, kSums> sizes{};
  for (std::size_t sum = 0; sum < kSums; ++sum)
    sizes[sum] = static_cast<std::uint8_t>(size_of(static_cast<int>(sum)));
  return sizes;
}();

std::size_t quick_size_of(int sum) {
  return kSizeOf[std::min(static_cast<std::size_t>(sum), kSums - 1)];
}

double bits_of(int magnitude, int before, int above) {
  const BitsOfMagnitudes& of = kBits[quick_size_of(before)][quick_size_of(above)];
  if (magnitude < kMagnitudes - 1) return of[magnitude];
  return of[kMagnitudes - 1] + 2 * std::log2(magnitude - kMagnitudes + 2.0);
}

/// Bits of a coefficient among zeros, plus those of the zeros whose context it is part of: two in
/// its band and, except in the finest band, four children.
double bits_among_zeros(int magnitude, bool has_children) {
  const double in_band =
      bits_of(magnitude, 0, 0) + bits_of(0, 2 * magnitude, 0) + bits_of(0, magnitude, 0);
  return has_children ? in_band + 2 * bits_of(0, 0, 2 * magnitude) + 2 * bits_of(0, 0, magnitude)
                      : in_band;
}

BitsOfMagnitudes make_lonely(bool has_children) {
  BitsOfMagnitudes lonely{};
  for (int m = 0; m < kMagnitudes; ++m) lonely[m] = bits_among_zeros(m, has_children);
  return lonely;
}

const std::array<BitsOfMagnitudes, 2> kLonely = {make_lonely(false), make_lonely(true)};

std::uint64_t eight_from(const std::uint8_t* bytes) {
  std::uint64_t eight;
  std::memcpy(&eight, bytes, sizeof eight);
  return eight;
}

std::uint32_t four_from(const std::uint8_t* bytes) {
  std::uint32_t four;
  std::memcpy(&four, bytes, sizeof four);
  return four;
}

/// A mask of the first `count` of eight bytes in memory order.
std::uint64_t first_bytes(int count) {
  const std::array<std::uint8_t, 8> all = [count] {
    std::array<std::uint8_t, 8> bytes{};
    std::fill_n(bytes.begin(), count, std::uint8_t{0xFF});
    return bytes;
  }();
  return eight_from(all.data());
}

// Masks over eight neighbouring coefficients, a byte each. In kBesideIt the coefficient itself is
// the third byte: the mask keeps two neighbours on either side. In kAboutChildren its two children
// are the fourth and fifth byte: the mask keeps them, three before and one after.
const std::uint64_t kBesideIt = first_bytes(5) ^ first_bytes(3) ^ first_bytes(2);
const std::uint64_t kAboutChildren = first_bytes(6);

}  // namespace

Magnitudes::Magnitudes(const std::vector<Band>& bands) {
  std::size_t bytes = 0;
  for (const Band& band : bands) {
    places_.push_back(bytes + kBefore);
    bytes += static_cast<std::size_t>(kBefore + band.size + kAfter);
  }
  bytes_.resize(bytes);
}

void Magnitudes::read(const std::vector<Band>& bands, const int* signal) {
  for (std::size_t b = 0; b < bands.size(); ++b)
    std::transform(signal + bands[b].first, signal + bands[b].first + bands[b].size,
                   bytes_.begin() + static_cast<std::ptrdiff_t>(places_[b]), of);
}

RateTable::Neighbours RateTable::neighbours_of(const std::uint8_t* own, const std::uint8_t* upper,
                                               int i) {
  Neighbours found;
  found.before = 2 * own[i - 1] + own[i - 2];
  if (upper) {
    const int k = i / 2;
    found.above = 2 * upper[k] + upper[i % 2 != 0 ? k + 1 : k - 1];
  }
  return found;
}

/// Returns the magnitudes of the parents' band, or null for the coarsest details, which have no
/// parents.
const std::uint8_t* RateTable::above(const Magnitudes& magnitudes, int b) const {
  return b > 1 ? magnitudes.in(b - 1) : nullptr;
}

double RateTable::bits(const Magnitudes& magnitudes, int b, int i, int value) const {
  const auto [before, above] = neighbours_of(magnitudes.in(b), this->above(magnitudes, b), i);
  return bits_of(std::abs(value), before, above);
}

RateTable::Around::Around(const RateTable& table, const Magnitudes& magnitudes, int b, int i) {
  const std::vector<Band>& bands = table.bands_;
  const int size = bands[b].size;
  const std::uint8_t* const own = magnitudes.in(b);
  const std::uint8_t* const upper = table.above(magnitudes, b);
  const bool has_children = static_cast<std::size_t>(b) + 1 < bands.size();
  const int children = has_children ? bands[static_cast<std::size_t>(b) + 1].size : 0;
  const std::uint8_t* const lower = has_children ? magnitudes.in(b + 1) : nullptr;

  const bool is_inside = i > 0 && i + 2 < size && (!has_children || 2 * i + 2 < children);
  if (is_inside && (eight_from(own + i - 2) & kBesideIt) == 0 &&
      (!upper || four_from(upper + i / 2 - 1) == 0) &&
      (!lower || (eight_from(lower + 2 * i - 3) & kAboutChildren) == 0)) {
    is_lonely_ = true;
    count_ = has_children ? 1 : 0;
    return;
  }

  const auto [before, above] = neighbours_of(own, upper, i);
  before_ = before;
  above_ = above;
  const int mine = own[i];
  const auto follow = [&](const std::uint8_t* band, const std::uint8_t* over, int k,
                          int share_of_before, int share_of_above) {
    const auto found = neighbours_of(band, over, k);
    followers_[count_++] = {band[k], found.before - share_of_before * mine,
                            found.above - share_of_above * mine, share_of_before, share_of_above};
  };
  for (int k = i + 1; k <= i + 2 && k < size; ++k) follow(own, upper, k, k == i + 1 ? 2 : 1, 0);
  for (int k = std::max(2 * i - 1, 0); k <= 2 * i + 2 && k < children; ++k)
    follow(lower, own, k, 0, k / 2 == i ? 2 : 1);
}

double RateTable::Around::bits(int value) const {
  const int magnitude = std::abs(value);
  if (is_lonely_) {
    const bool has_children = count_ > 0;
    return magnitude < kMagnitudes ? kLonely[has_children][magnitude]
                                   : bits_among_zeros(magnitude, has_children);
  }
  double sum = bits_of(magnitude, before_, above_);
  for (int f = 0; f < count_; ++f) {
    const Follower& follower = followers_[f];
    sum += bits_of(follower.magnitude, follower.before + follower.share_of_before * magnitude,
                   follower.above + follower.share_of_above * magnitude);
  }
  return sum;
}

double RateTable::bits(const int* signal, const Magnitudes& magnitudes) const {
  constexpr int kRun = 4;
  double sum = 0;
  for (int i = 0; i < bands_[0].size; ++i)
    sum += coarse_bits(signal[i] - (i > 0 ? signal[i - 1] : 0));
  for (int b = 1; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[b];
    const std::uint8_t* const own = magnitudes.in(b);
    const std::uint8_t* const upper = above(magnitudes, b);
    if (std::all_of(own, own + band.size, [](std::uint8_t m) { return m == 0; })) continue;
    int lonely = 0;
    for (int i = 0; i < band.size; i += kRun) {
      const int end = std::min(i + kRun, band.size);
      if (eight_from(own + i - 2) == 0 && (!upper || four_from(upper + i / 2 - 1) == 0)) {
        lonely += end - i;
        continue;
      }
      for (int k = i; k < end; ++k) {
        const auto [before, above] = neighbours_of(own, upper, k);
        sum += bits_of(std::abs(signal[band.first + k]), before, above);
      }
    }
    sum += lonely * bits_of(0, 0, 0);
  }
  return sum;
}

}  // namespace mocapress
