// SPDX-License-Identifier: MIT
#include "core/runtime/instant_weights.h"

#include <algorithm>

#include "core/codec/format/interpolation.h"

namespace mocapress::runtime {
namespace {

constexpr float kUpdate = 0.25F;

/// Where no border is near.
void weigh_inside(Wavelet wavelet, const RowWeights& samples, RowWeights& evens,
                  RowWeights& details) {
  const InnerWeights inner = inner_weights(wavelet);
  const auto near = static_cast<float>(inner.near);
  const auto far = static_cast<float>(inner.far);
  const int parity = samples.first & 1;
  const int middle = samples.first >> 1;
  const float* const w = samples.weight;
  // Odd and even samples from 2 * middle on, of which there are three and four.
  const float o0 = parity != 0 ? w[0] : w[1];
  const float o1 = parity != 0 ? w[2] : w[3];
  const float o2 = parity != 0 ? w[4] : w[5];
  const float e0 = parity != 0 ? 0 : w[0];
  const float e1 = parity != 0 ? w[1] : w[2];
  const float e2 = parity != 0 ? w[3] : w[4];
  const float e3 = parity != 0 ? w[5] : 0;
  float* const e = evens.weight;
  e[0] = far * o0;
  e[1] = e0 + (near * o0 + far * o1);
  e[2] = e1 + (near * (o0 + o1) + far * o2);
  e[3] = e2 + (near * (o1 + o2) + far * o0);
  e[4] = e3 + (near * o2 + far * o1);
  e[5] = far * o2;
  e[6] = 0;
  e[7] = 0;
  evens.first = middle - 1;
  // From an even row on.
  const int odd_first = middle & 1;
  details.first = middle - 2 - odd_first;
  details.weight[0] = 0;
  details.weight[7] = 0;
  float* const d = details.weight + odd_first;
  d[0] = -kUpdate * e[0];
  d[1] = -kUpdate * (e[0] + e[1]);
  d[2] = o0 - kUpdate * (e[1] + e[2]);
  d[3] = o1 - kUpdate * (e[2] + e[3]);
  d[4] = o2 - kUpdate * (e[3] + e[4]);
  d[5] = -kUpdate * (e[4] + e[5]);
  d[6] = -kUpdate * e[5];
}

/// Anywhere, by the rules of FORMAT.md one by one.
void weigh_anywhere(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                    RowWeights& details) {
  constexpr int kRoom = 16;
  const int even_count = evens_in(length);
  const int odd_count = odds_in(length);
  const int origin = (samples.first >> 1) - 4;  // row 0 of these:
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

}  // namespace

bool weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details) {
  const int first_odd = samples.first >> 1;
  const int last_odd = first_odd + 2;
  // Three odd samples that are predicted from two on each side, and evens with details beside them.
  const bool inside = wavelet != Wavelet::Haar && first_odd > 1 && last_odd + 2 < odds_in(length) &&
                      last_odd < evens_in(length) - 2;
  if (inside)
    weigh_inside(wavelet, samples, evens, details);
  else
    weigh_anywhere(wavelet, length, samples, evens, details);
  return inside;
}

}  // namespace mocapress::runtime
