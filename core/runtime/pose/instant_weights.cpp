// SPDX-License-Identifier: MIT
#include "core/runtime/pose/instant_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/runtime/format/interpolation.h"

namespace mocapress::runtime {
namespace {

constexpr float kUpdate = 0.25F;
constexpr float kMostWeight = 1.4F;  // largest weight; times 2^14.5 it is below 2^15

/// The factor on integer weights of dense rows: 2^15 * 2^floor((depth - 1) / 2) * 2^(-depth / 2).
constexpr float scale_of_band(int depth) {
  return depth % 2 == 0 ? 16384 : 23170.475F;
}

/// The shift from the integer weights of a band's dense rows to those of its entries. These have a
/// factor of 2^17 in every band, where dense rows have 2^15 * 2^floor((depth - 1) / 2).
constexpr int entry_shift(int depth) {
  return 2 - (depth - 1) / 2;
}

/// Weights of samples, split for one step backwards: those of three odd samples from 2 * middle + 1
/// on, and of four even samples from 2 * middle on.
struct Split {
  int middle;
  float odd[3];
  float even[4];
};

constexpr Split split(const RowWeights& samples) {
  const float* const w = samples.weight;
  if ((samples.first & 1) != 0)
    return {samples.first >> 1, {w[0], w[2], w[4]}, {0, w[1], w[3], w[5]}};
  return {samples.first >> 1, {w[1], w[3], w[5]}, {w[0], w[2], w[4], 0}};
}

/// Splits the weights, from any `middle` at or before the first sample.
Split split_from(int middle, const RowWeights& samples) {
  const auto at = [&](int i) {
    const int k = 2 * middle + i - samples.first;
    return k >= 0 && k < 8 ? samples.weight[k] : 0.0F;
  };
  return {middle, {at(1), at(3), at(5)}, {at(0), at(2), at(4), at(6)}};
}

/// Finds the weights of the even samples, away from the borders.
constexpr void weigh_evens(Wavelet wavelet, const Split& samples, RowWeights& evens) {
  const InnerWeights inner = inner_weights(wavelet);
  const auto near = static_cast<float>(inner.near);
  const auto far = static_cast<float>(inner.far);
  const auto [o0, o1, o2] = samples.odd;
  const auto [e0, e1, e2, e3] = samples.even;
  evens = {samples.middle - 1,
           {far * o0, e0 + (near * o0 + far * o1), e1 + (near * (o0 + o1) + far * o2),
            e2 + (near * (o1 + o2) + far * o0), e3 + (near * o2 + far * o1), far * o2, 0, 0}};
}

constexpr void weigh_details(const Split& samples, const RowWeights& evens, RowWeights& details) {
  const int odd_first = samples.middle & 1;
  const float* const e = evens.weight;
  details = {samples.middle - 2 - odd_first, {}};
  float* const d = details.weight + odd_first;
  d[0] = -kUpdate * e[0];
  for (int i = 1; i < 6; ++i) d[i] = -kUpdate * (e[i - 1] + e[i]);
  d[6] = -kUpdate * e[5];
  for (int i = 0; i < 3; ++i) d[2 + i] += samples.odd[i];
}

/// Handles the general case: Haar wavelets, which predict an odd sample from the even one before
/// it, and signals with fewer than four even samples.
void weigh_one_by_one(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                      RowWeights& details) {
  constexpr int kRoom = 16;
  const int even_count = evens_in(length);
  const int odd_count = odds_in(length);
  const int origin = (samples.first >> 1) - 4;  // row number of element 0 in the arrays below
  float even[kRoom] = {};
  float odd[kRoom] = {};
  for (int i = 0; i < 8; ++i) {
    const int at = samples.first + i;
    if (samples.weight[i] == 0 || at < 0 || at >= length) continue;
    (at % 2 == 0 ? even : odd)[at / 2 - origin] += samples.weight[i];
  }
  for (int i = 0; i < kRoom; ++i) {
    if (odd[i] == 0) continue;
    const Neighbours neighbours = neighbours_of(wavelet, origin + i, even_count);
    float weights[kMostNeighbours];
    weights_of(wavelet, origin + i, neighbours, weights);
    for (int n = 0; n < neighbours.count; ++n)
      even[neighbours.first + n - origin] += odd[i] * weights[n];
  }
  for (int i = 0; i < kRoom; ++i) {
    const int at = origin + i;
    if (even[i] == 0) continue;
    const bool has_after = at < odd_count;
    const bool has_before = at > 0 && wavelet != Wavelet::Haar;
    if (wavelet == Wavelet::Haar && !has_after) continue;
    const int after = has_after ? at : at - 1;
    const int before = has_before ? at - 1 : at;
    odd[after - origin] -= kUpdate * even[i];
    odd[before - origin] -= kUpdate * even[i];
  }
  const auto put = [&](const float* from, RowWeights& to) {
    int first = 0;
    while (first < kRoom - 8 && from[first] == 0) ++first;
    to.first = origin + first;
    std::copy_n(from + first, 8, to.weight);
  };
  put(even, evens);
  put(odd, details);
}

/// Moves the weights of rows beyond a border to rows within it.
struct Fold {
  RowWeights& rows;
  float& at(int row) const { return rows.weight[row - rows.first]; }
  float take(int row) const { return std::exchange(at(row), 0.0F); }
  bool has(int row) const { return row >= rows.first && row < rows.first + 8; }
  /// Replaces a row by its cubic extrapolation from four rows: `next`, next + way and so on.
  void to_cubic(int row, int next, int way) const {
    const float weight = take(row);
    if (weight == 0) return;
    constexpr float kCubic[4] = {4, -6, 4, -1};
    for (int i = 0; i < 4; ++i) at(next + i * way) += kCubic[i] * weight;
  }
};

/// Tables of weights away from the borders. The weights repeat as the frame number grows, and each
/// table covers one period.
struct InnerTables {
  struct Band {
    float at_frame[kDetailWindow];  // weights of the window's rows at the frame, multiplied by
                                    // scale_of_band()
    float to_next[kDetailWindow];   // differences from these to the weights at the next frame
  };
  struct Samples {
    float at_frame[8];
    float to_next[8];
  };
  // Index of a band's weights. Bands come one after the other, the finest first, with periods of 4,
  // 8, 16 ... frames.
  static constexpr int band_of(int depth, int frame) {
    const int length = 2 << depth;
    return length - 4 + (frame & (length - 1));
  }
  // Index of the samples' weights after leaving out bands. The weights repeat every 2^left_out
  // frames.
  static constexpr int samples_of(int left_out, int frame) {
    const int length = 1 << left_out;
    return length - 1 + (frame & (length - 1));
  }
  static constexpr int kBandRows = (4 << kMostKeptBands) - 4;
  static constexpr int kSampleRows = (2 << kMostKeptBands) - 1;

  alignas(32) Band band[kBandRows] = {};
  std::int8_t used[kBandRows][2] = {};  // first and last nonzero row of the window
  alignas(32) Samples samples[kSampleRows] = {};
};

constexpr InnerTables inner_tables(Wavelet wavelet) {
  InnerTables tables;
  for (int frame = 0; frame < 2 << kMostKeptBands; ++frame) {
    // Weights of the samples at `frame` and at the next frame, in windows with the same first row.
    RowWeights row[2] = {{frame, {1, 0}}, {frame, {0, 1}}};
    for (int depth = 0; depth <= kMostKeptBands; ++depth) {
      InnerTables::Samples& samples = tables.samples[InnerTables::samples_of(depth, frame)];
      for (int i = 0; i < 8; ++i) {
        samples.at_frame[i] = row[0].weight[i];
        samples.to_next[i] = row[1].weight[i] - row[0].weight[i];
      }
      if (depth == kMostKeptBands) break;
      RowWeights details[2];
      for (int k = 0; k < 2; ++k) {
        const Split samples_of_level = split(row[k]);
        weigh_evens(wavelet, samples_of_level, row[k]);
        weigh_details(samples_of_level, row[k], details[k]);
      }
      const int at = InnerTables::band_of(depth + 1, frame);
      InnerTables::Band& band = tables.band[at];
      int first = kDetailWindow;
      int last = 0;
      for (int i = 0; i < kDetailWindow; ++i) {
        const float scale = scale_of_band(depth + 1);
        band.at_frame[i] = details[0].weight[i] * scale;
        band.to_next[i] = details[1].weight[i] * scale - band.at_frame[i];
        if (band.at_frame[i] == 0 && band.to_next[i] == 0) continue;
        first = std::min(first, i);
        last = i;
      }
      tables.used[at][0] = static_cast<std::int8_t>(first);
      tables.used[at][1] = static_cast<std::int8_t>(last);
    }
  }
  return tables;
}

constexpr InnerTables kLinearTables = inner_tables(Wavelet::Linear);
constexpr InnerTables kCubicTables = inner_tables(Wavelet::Cubic);

/// True if one level of the transform, run backwards, stays away from the borders.
bool is_inside(int first_sample, int length) {
  const int first_odd = first_sample >> 1;
  // Three odd samples need two even ones on each side, and these need the details beside them.
  return first_odd > 1 && first_odd + 4 < odds_in(length);
}

/// The same weights in a window whose first row is `first`.
RowWeights moved(const RowWeights& from, int first) {
  RowWeights to;
  to.first = first;
  for (int i = 0; i < 8; ++i) {
    const int k = i - (from.first - first);
    to.weight[i] = k >= 0 && k < 8 ? from.weight[k] : 0;
  }
  return to;
}

void set_samples(const RowWeights& from, int rows, SampleWeights& to) {
  const int first = std::clamp(from.first, 0, std::max(rows - kSampleWindow, 0));
  to.first_row = first;
  if (first == from.first)
    std::copy_n(from.weight, kSampleWindow, to.of_row);
  else
    std::copy_n(moved(from, first).weight, kSampleWindow, to.of_row);
}

void set_band(const PoseKernels& kernels, const RowWeights& from, int rows, int depth, float unit,
              BandWeights& to) {
  const int padded = std::max((rows + 1) / 2 * 2, kDetailWindow);
  int before = 0;  // number of leading rows with weight zero
  while (before < kDetailWindow - 1 && from.weight[before] == 0) ++before;
  const int first = depth == 1 ? std::clamp((from.first + before) & ~1, 0, padded - kFinestWindow)
                               : std::clamp(from.first & ~1, 0, padded - kDetailWindow);
  to.first_row = first;
  const RowWeights weights = first == from.first ? from : moved(from, first);
  int used = 0;
  while (used < kDetailWindow - 1 && weights.weight[used] == 0) ++used;
  to.first_used = first + used;
  used = kDetailWindow - 1;
  while (used > 0 && weights.weight[used] == 0) --used;
  to.last_used = first + used;
  float scaled[2 * kDetailWindow] = {};
  for (int i = 0; i < kDetailWindow; ++i)
    scaled[i] = weights.weight[i] * (scale_of_band(depth) / unit);
  kernels.set_band(scaled, 0, entry_shift(depth), to);
}

}  // namespace

void weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details) {
  const int even_count = evens_in(length);
  const int odd_count = odds_in(length);
  if (wavelet == Wavelet::Haar || even_count < kMostNeighbours)
    return weigh_one_by_one(wavelet, length, samples, evens, details);
  // An odd sample after the last even one is extrapolated linearly.
  RowWeights without = samples;
  const int beyond = odd_count == even_count ? length - 1 - samples.first : -1;
  const float goes_on = beyond >= 0 && beyond < 8 ? std::exchange(without.weight[beyond], 0.0F) : 0;
  const Split apart =
      split_from(std::min(samples.first >> 1, even_count - kMostNeighbours), without);
  weigh_evens(wavelet, apart, evens);
  const Fold fold{evens};
  if (goes_on != 0) {
    fold.at(even_count - 1) += 1.5F * goes_on;
    fold.at(even_count - 2) -= 0.5F * goes_on;
  }
  if (fold.has(-1)) fold.to_cubic(-1, 0, 1);
  if (fold.has(even_count)) fold.to_cubic(even_count, even_count - 1, -1);
  weigh_details(apart, evens, details);
  const Fold sides{details};
  if (goes_on != 0) sides.at(odd_count - 1) += goes_on;
  if (sides.has(-1)) sides.at(0) += sides.take(-1);
  if (odd_count < even_count && sides.has(odd_count))
    sides.at(odd_count - 1) += sides.take(odd_count);
}

void InstantWeights::set(const PoseKernels& kernels, Wavelet wavelet, int length, int frame,
                         float share, int kept, unsigned wanted) {
  const InnerTables* const tables = wavelet == Wavelet::Haar     ? nullptr
                                    : wavelet == Wavelet::Linear ? &kLinearTables
                                                                 : &kCubicTables;
  unit = 1;
  RowWeights row;
  row.first = frame;
  row.weight[0] = 1 - share;
  row.weight[1] = share;
  RowWeights details[kMostKeptBands];
  int rows[kMostKeptBands];
  int inside = 0;  // number of levels, from the finest on, whose rows are away from the borders
  for (levels = 0;; ++levels, length = evens_in(length)) {
    const bool is_last = levels == kept || length < kCoarsest;
    const bool goes_on_inside =
        !is_last && tables != nullptr && inside == levels && is_inside(row.first, length);
    if (inside == levels && levels > 0 && (!goes_on_inside || (wanted >> levels & 1) != 0)) {
      const InnerTables::Samples& from = tables->samples[InnerTables::samples_of(levels, frame)];
      for (int i = 0; i < 8; ++i) row.weight[i] = from.at_frame[i] + share * from.to_next[i];
    }
    if (is_last || (wanted >> levels & 1) != 0) set_samples(row, length, samples[levels]);
    if (is_last) break;
    BandWeights& to = band[levels];
    if (goes_on_inside) {
      const int at = InnerTables::band_of(levels + 1, frame);
      const int middle = row.first >> 1;
      to.first_row = middle - 2 - (middle & 1);
      to.first_used = to.first_row + tables->used[at][0];
      to.last_used = to.first_row + tables->used[at][1];
      kernels.set_band(tables->band[at].at_frame, share, entry_shift(levels + 1), to);
      row.first = middle - 1;
      ++inside;
      continue;
    }
    RowWeights evens;
    weigh_level(wavelet, length, row, evens, details[levels]);
    rows[levels] = odds_in(length);
    row = evens;
    // Only the linear extrapolation after the last even sample makes weights that large.
    for (const float weight : details[levels].weight)
      while (std::abs(weight) > kMostWeight * unit) unit *= 2;
  }
  for (int b = 0; b < inside && unit > 1; ++b) {
    float weights[2 * kDetailWindow] = {};
    for (int i = 0; i < kDetailWindow; ++i)
      weights[i] = static_cast<float>(band[b].of_row[2 + i]) / unit;
    kernels.set_band(weights, 0, entry_shift(b + 1), band[b]);
  }
  for (int b = inside; b < levels; ++b)
    set_band(kernels, details[b], rows[b], b + 1, unit, band[b]);
}

}  // namespace mocapress::runtime
