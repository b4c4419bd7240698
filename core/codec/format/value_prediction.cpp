// SPDX-License-Identifier: MIT
#include "core/codec/format/value_prediction.h"

namespace mocapress::runtime {

constexpr std::array<std::int32_t, kScales> kInverseScales = {
    524288, 440872, 370728, 311744, 262144, 220436, 185364, 155872, 131072, 110218, 92682,
    77936,  65536,  55109,  46341,  38968,  32768,  27554,  23170,  19484,  16384,  13777,
    11585,  9742,   8192,   6889,   5793,   4871,   4096,   3444,   2896,   2435,   2048,
    1722,   1448,   1218,   1024,   861,    724,    609,    512,    431,    362,    304,
    256,    215,    181,    152,    128,    108,    91,     76,     64,     54,     45,
    38,     32,     27,     23,     19,     16,     13,     11,     10};

constexpr std::array<std::int32_t, 65> kLogisticTails = {
    536870912, 470109403, 405381206, 344479249, 288773652, 239122453, 195877915, 158964468,
    127993163, 102380708, 81452101,  64517549,  50923144,  40079440,  31473768,  24671763,
    19312546,  15100705,  11797140,  9210005,   7186394,   5605067,   4370277,   3406642,
    2654959,   2068816,   1611882,   1255752,   978234,    762003,    593542,    462307,
    360079,    280451,    218428,    170120,    132494,    103189,    80366,     62590,
    48746,     37963,     29566,     23026,     17933,     13966,     10877,     8471,
    6597,      5138,      4001,      3116,      2427,      1890,      1472,      1146,
    893,       695,       542,       422,       328,       256,       199,       155,
    121};

constexpr ScaleWeights kScaleWeights = {
    {{296, 172, 77, 4, 4, 0, 1, 50, 1, 6, 116, 8, 0, 0, 0, 0, 29, 24},
     {208, 111, 62, 40, 19, 1, 1, 35, 2, 8, 79, 12, 0, 0, 1, 0, 13, 13},
     {214, 115, 83, 63, 28, 3, 2, 38, 4, 11, 79, 18, 0, 0, 4, 1, 8, 9},
     {204, 109, 75, 84, 30, 8, 2, 33, 5, 14, 91, 22, 1, 0, 10, 2, 7, 6},
     {205, 111, 25, 89, 40, 13, 4, 38, 10, 18, 125, 31, 2, 1, 20, 7, 6, 5},
     {218, 69, 34, 145, 39, 23, 5, 41, 10, 25, 158, 36, 6, 2, 27, 29, 7, 4},
     {190, 49, 23, 131, 33, 28, 8, 75, 26, 30, 252, 42, 25, 8, 36, 124, 12, 7},
     {310, 43, 24, 170, 27, 47, 10, 100, 43, 33, 317, 47, 50, 16, 58, 258, 20, 14}}};

void SignalPrediction::begin() {
  constexpr std::int32_t kRidge = 20 << 12;  // as if each tap had been seen so often beside zero
  products.fill(0);
  for (int i = 0; i < kTaps; ++i) product(i, i) = kRidge;
  errors.fill(0);
  weights.fill(0);
  seen = 0;
}

int SignalPrediction::of(const Taps& taps) const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < kTaps; ++i) sum += static_cast<std::int64_t>(weights[i]) * taps[i];
  return static_cast<int>(std::clamp<std::int64_t>(sum >> 14, -2 * kFarthest, 2 * kFarthest));
}

void SignalPrediction::follow(const Taps& taps, int error) {
  constexpr std::int32_t kMost = 512;  // then what was seen counts half
  bool any = false;
  std::int32_t* row = products.data();
  for (std::size_t i = 0; i < kTaps; row += kTaps, ++i) {
    const std::int16_t tap = taps[i];
    if (tap == 0) continue;
    any = true;
    for (std::size_t j = 0; j < kTaps; ++j) row[j] += tap * taps[j];
    errors[i] += static_cast<std::int64_t>(tap) * error;
  }
  if (!any) return;
  if (++seen == kMost) {
    seen /= 2;
    for (std::int32_t& product : products) product >>= 1;
    for (std::int64_t& left : errors) left >>= 1;
  }
  // The weights that would change most.
  constexpr int kMoves = 2;
  for (int move = 0; move < kMoves; ++move) {
    int most = 0;
    std::int64_t largest = -1;
    for (int i = 0; i < kTaps; ++i) {
      const std::int64_t left = errors[static_cast<std::size_t>(i)];
      const std::int64_t size = left < 0 ? -left : left;
      if (size <= largest) continue;
      largest = size;
      most = i;
    }
    move_weight(most);
  }
}

void SignalPrediction::move_weight(int tap) {
  constexpr std::int64_t kLargestMove = 8192;
  constexpr std::int64_t kLargest = 1 << 17;
  constexpr std::int64_t kMostLeft = std::int64_t{1} << 40;  // hostile bytes cannot overflow
  auto& weight = weights[static_cast<std::size_t>(tap)];
  const std::int64_t wanted =
      (errors[static_cast<std::size_t>(tap)] << 14) / std::max(product(tap, tap), 1);
  const std::int64_t moved =
      std::clamp<std::int64_t>(weight + std::clamp(wanted, -kLargestMove, kLargestMove), -kLargest,
                               kLargest) -
      weight;
  if (moved == 0) return;
  weight += static_cast<std::int32_t>(moved);
  for (int i = 0; i < kTaps; ++i) {
    const std::int32_t both = product(tap, i);
    std::int64_t& left = errors[static_cast<std::size_t>(i)];
    left = std::clamp(left - (moved * both >> 14), -kMostLeft, kMostLeft);
  }
}

}  // namespace mocapress::runtime
