// SPDX-License-Identifier: MIT
// value_prediction.cpp for vectors of four: SSE2, NEON or WebAssembly. Computes the same integers.
// What takes 64 bits is left to the plain code.
#include "core/runtime/format/value_prediction.h"
#include "core/runtime/processor/four.h"

#ifdef MOCAPRESS_FOUR

namespace mocapress::runtime {
namespace four_prediction {
namespace {

constexpr int kTaps = SignalPrediction::kTaps;
static_assert(kTaps % 8 == 0 && RestPrediction::kTaps % 8 == 0);

int of_signal(const SignalPrediction& prediction, const std::int16_t* taps) {
  return prediction.of(taps);
}

void signal_follows(SignalPrediction& prediction, const std::int16_t* taps, int error) {
  Ints4 all[kTaps / 4];
  std::int16_t any = 0;
  for (int i = 0; i < kTaps; ++i) any = static_cast<std::int16_t>(any | taps[i]);
  if (any == 0) return;
  for (int v = 0; v < kTaps / 8; ++v) {
    const Words8 words = Words8::load(taps + 8 * v);
    all[2 * v] = words.low();
    all[2 * v + 1] = words.high();
  }
  std::int32_t* row = prediction.products.data();
  for (int i = 0; i < kTaps; row += kTaps, ++i) {
    if (taps[i] == 0) continue;
    const Ints4 tap = Ints4::all(taps[i]);
    for (int v = 0; v < kTaps / 4; ++v)
      (Ints4::load(row + 4 * v) + short_product(all[v], tap)).store(row + 4 * v);
  }
  prediction.learn(taps, error);
}

int of_rest(const RestPrediction& rest, const RestPrediction::Taps& taps) {
  Ints4 sums = Ints4::all(0);
  for (int i = 0; i < RestPrediction::kTaps; i += 8) {
    const Words8 words = Words8::load(taps.data() + i);
    const std::int32_t* const weights = rest.weights.data() + i;
    sums = sums + short_product(Ints4::load(weights) >> 8, words.low()) +
           short_product(Ints4::load(weights + 4) >> 8, words.high());
  }
  return std::clamp(((1 << 11) + sums.sum()) >> 12, -2 * SignalPrediction::kFarthest,
                    2 * SignalPrediction::kFarthest);
}

void rest_follows(RestPrediction& rest, const RestPrediction::Taps& taps, int error) {
  Ints4 sums = Ints4::all(0);
  for (int i = 0; i < RestPrediction::kTaps; i += 8) {
    const Words8 words = Words8::load(taps.data() + i);
    sums = sums + pair_products(words, words);
  }
  const Ints4 step =
      Ints4::all(RestPrediction::step_of(error, RestPrediction::kRidge + sums.sum()));
  const Ints4 most = Ints4::all(RestPrediction::kMost);
  const Ints4 least = Ints4::all(-RestPrediction::kMost);
  const auto move = [&](std::int32_t* weights, Ints4 of_taps) {
    const Ints4 moved = Ints4::load(weights) + short_product(of_taps, step);
    larger(smaller(moved, most), least).store(weights);
  };
  for (int i = 0; i < RestPrediction::kTaps; i += 8) {
    const Words8 words = Words8::load(taps.data() + i);
    move(rest.weights.data() + i, words.low());
    move(rest.weights.data() + i + 4, words.high());
  }
}

void normalise(const std::array<std::int32_t, RestPrediction::kTaps>& values, std::int32_t inverse,
               RestPrediction::Taps& taps) {
  const Ints4 by = Ints4::all(inverse);
  const Ints4 most = Ints4::all(largest_normal(inverse));
  const Ints4 least = Ints4::all(-largest_normal(inverse));
  const Ints4 farthest = Ints4::all(SignalPrediction::kFarthest);
  const Ints4 nearest = Ints4::all(-SignalPrediction::kFarthest);
  const auto scaled = [&](const std::int32_t* from) {
    const Ints4 clamped = larger(smaller(Ints4::load(from), most), least);
    return larger(smaller(clamped * by >> 10, farthest), nearest);
  };
  for (int i = 0; i < RestPrediction::kTaps; i += 8)
    Words8::packed(scaled(values.data() + i), scaled(values.data() + i + 4)).store(taps.data() + i);
}

}  // namespace
}  // namespace four_prediction

const PredictionKernels kFourPrediction = {
    four_prediction::of_signal, four_prediction::signal_follows, four_prediction::of_rest,
    four_prediction::rest_follows, four_prediction::normalise};

}  // namespace mocapress::runtime
#endif
