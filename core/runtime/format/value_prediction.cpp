// SPDX-License-Identifier: MIT
#include "core/runtime/format/value_prediction.h"

#include "core/runtime/processor/path.h"

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
    {{118, 28, 14, 36, 20, 1, 1, 87, 1, 1, 29, 1, 74, 1, 1, 1, 51, 18},
     {124, 28, 1, 30, 21, 4, 1, 29, 1, 3, 34, 1, 12, 1, 129, 1, 28, 5},
     {90, 62, 15, 44, 21, 9, 3, 16, 1, 47, 7, 46, 39, 1, 121, 1, 10, 6},
     {139, 98, 25, 45, 22, 10, 1, 15, 3, 31, 59, 33, 97, 1, 84, 278, 37, 5},
     {180, 110, 32, 52, 32, 16, 1, 15, 13, 18, 75, 31, 79, 1, 38, 632, 39, 8},
     {210, 100, 20, 64, 42, 31, 1, 13, 20, 6, 94, 26, 105, 1, 51, 842, 43, 13},
     {235, 60, 7, 86, 52, 40, 4, 9, 30, 1, 147, 26, 75, 1, 74, 1817, 51, 26},
     {247, 45, 34, 119, 69, 79, 13, 19, 18, 18, 206, 13, 137, 1, 162, 3072, 54, 26}}};

void SignalPrediction::begin() {
  constexpr std::int32_t kRidge = 40 << 12;  // initial regularisation: as if each tap had been 1.0
                                             // (64) in 40 observations of the value 0
  products.fill(0);
  for (int i = 0; i < kTaps; ++i) product(i, i) = kRidge;
  errors.fill(0);
  weights.fill(0);
  seen = 0;
}

int SignalPrediction::of(const std::int16_t* taps) const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < kTaps; ++i) sum += static_cast<std::int64_t>(weights[i]) * taps[i];
  return static_cast<int>(std::clamp<std::int64_t>(sum >> 14, -2 * kFarthest, 2 * kFarthest));
}

void SignalPrediction::halve() {
  seen /= 2;
  for (std::int32_t& product : products) product >>= 1;
  for (std::int64_t& left : errors) left >>= 1;
}

std::int64_t SignalPrediction::move_weight(int tap) {
  constexpr std::int64_t kLargestMove = 8192;
  constexpr std::int64_t kLargest = 1 << 17;
  auto& weight = weights[static_cast<std::size_t>(tap)];
  const std::int64_t wanted =
      (errors[static_cast<std::size_t>(tap)] << 14) / std::max(product(tap, tap), 1);
  const std::int64_t moved =
      std::clamp<std::int64_t>(weight + std::clamp(wanted, -kLargestMove, kLargestMove), -kLargest,
                               kLargest) -
      weight;
  weight += static_cast<std::int32_t>(moved);
  return moved;
}

void SignalPrediction::follow(const std::int16_t* taps, int error) {
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
  if (++seen == kMostSeen) halve();
  // Updates the weights with the largest remaining errors.
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
    const std::int64_t moved = move_weight(most);
    if (moved == 0) continue;
    for (int i = 0; i < kTaps; ++i) {
      std::int64_t& left = errors[static_cast<std::size_t>(i)];
      left = std::clamp(left - (moved * product(most, i) >> 14), -kMostLeft, kMostLeft);
    }
  }
}

// RestPrediction uses 32-bit sums and 16-bit products, since vector instructions compute several of
// those at once. They cannot overflow: weights are at most 4.0, and errors at most 5 kFarthest.

int RestPrediction::of(const Taps& taps) const {
  std::int32_t sum = 1 << 11;
  for (std::size_t i = 0; i < kTaps; ++i)
    sum += static_cast<std::int16_t>(weights[i] >> 8) * taps[i];
  return std::clamp(sum >> 12, -2 * SignalPrediction::kFarthest, 2 * SignalPrediction::kFarthest);
}

void RestPrediction::follow(const Taps& taps, int error) {
  std::int32_t squares = kRidge;
  for (const std::int16_t tap : taps) squares += tap * tap;
  const std::int16_t step = step_of(error, squares);
  for (std::size_t i = 0; i < kTaps; ++i)
    weights[i] = std::clamp(weights[i] + step * taps[i], -kMost, kMost);
}

const PredictionKernels kPlainPrediction = {
    [](const SignalPrediction& prediction, const std::int16_t* taps) {
      return prediction.of(taps);
    },
    [](SignalPrediction& prediction, const std::int16_t* taps, int error) {
      prediction.follow(taps, error);
    },
    [](const RestPrediction& rest, const RestPrediction::Taps& taps) { return rest.of(taps); },
    [](RestPrediction& rest, const RestPrediction::Taps& taps, int error) {
      rest.follow(taps, error);
    },
    [](const std::array<std::int32_t, RestPrediction::kTaps>& values, std::int32_t inverse,
       RestPrediction::Taps& taps) {
      for (std::size_t i = 0; i < taps.size(); ++i) taps[i] = normalised(values[i], inverse);
    }};

const PredictionKernels* prediction_of(mcpr_path path) {
  switch (kernels_of(path)) {
    case Kernels::None:
      break;
    case Kernels::Plain:
    case Kernels::Four:  // no faster with vectors of four: most of the work is on 64-bit integers
      return &kPlainPrediction;
    case Kernels::Avx2:
#ifdef MOCAPRESS_HAS_AVX2
      return &kAvx2Prediction;
#else
      break;
#endif
  }
  return nullptr;
}

}  // namespace mocapress::runtime
