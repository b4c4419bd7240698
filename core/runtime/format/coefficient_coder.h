// SPDX-License-Identifier: MIT
// The order of the adaptive coding, the same for writing, reading and counting: FORMAT.md,
// "Adaptive coding".
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/coefficient_model.h"
#include "core/runtime/format/coefficient_priors.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/signal_neighbours.h"
#include "core/runtime/format/value_prediction.h"

namespace mocapress::runtime {

inline constexpr int kLeastStepExponent = -128;
inline constexpr int kMostStepExponent = 127;
inline constexpr int kMostSteps = 1 << 28;  // no value is larger

/// Quantised coefficients of some signals, in memory of whoever made it.
struct QuantisedView {
  int length;  // coefficients of each signal, coarse to fine
  int signal_count;
  std::int32_t* step_exponent;  // of each signal: its step is scale * 2^(-step_exponent / 2)
  std::int32_t* values;         // signal after signal

  std::int32_t* signal(int s) const { return values + static_cast<std::ptrdiff_t>(s) * length; }
};

/// What a CoefficientCoder takes notes in.
struct CoderNotes {
  std::int64_t* sums;  // of magnitudes, in this band and the one above, by signal
  std::int64_t* sums_above;
  int* activity;  // of the band, from its coefficient -1
  int* restless;  // likewise: how much more than expected there was at each time, 256ths of octaves
  std::size_t activity_size;
  int* restless_signals;          // the same of each signal
  SignalPrediction* predictions;  // of each signal
  RestPrediction* rests;          // likewise

  CoderNotes(Memory& memory, const Bands& bands, int signal_count)
      : sums(memory.take<std::int64_t>(static_cast<std::uint64_t>(signal_count))),
        sums_above(memory.take<std::int64_t>(static_cast<std::uint64_t>(signal_count))),
        activity_size(static_cast<std::size_t>(bands[bands.count - 1].size) + 2) {
    activity = memory.take<int>(activity_size);
    restless = memory.take<int>(activity_size);
    restless_signals = memory.take<int>(static_cast<std::uint64_t>(signal_count));
    predictions = memory.take<SignalPrediction>(static_cast<std::uint64_t>(signal_count));
    rests = memory.take<RestPrediction>(static_cast<std::uint64_t>(signal_count));
  }
};

/// What a bit was predicted from: for `Bits` that want to know.
struct BitSources {
  std::array<int, kMostContexts> contexts;
  std::array<std::int32_t, 2> opinions;
  int context_count;
  int opinion_count;
  int set;    // of weights; -1: one context alone
  int scale;  // -1: no weights by scale
};

/// What the scale of a value was expected from, and what came: likewise.
struct ValueSources {
  std::array<int, kScaleFeatures> features;
  int level;
  int unrest;  // 256ths of octaves
  int mean;    // 64ths
  std::int32_t value;
};

/// Walks through signals in the order of the file. `Bits` either writes the bits it is given or
/// ignores and replaces them: bool code(bool bit, Probability one); refuse() when a number that was
/// read is out of bounds, and failed(), after which nothing that was read is of use. What is read
/// replaces what `coded` holds, which then must be zeros. Bits that have note(BitSources, bool) or
/// note(ValueSources) are told what each was predicted from.
template <typename Bits>
class CoefficientCoder {
 public:
  CoefficientCoder(Bits& bits, const SignalNeighbours* neighbours, const Bands& bands,
                   CoefficientModel& model, const QuantisedView& coded, const CoderNotes& notes,
                   float scale)
      : bits_(bits),
        neighbours_(neighbours),
        bands_(bands),
        model_(model),
        at_(model.layout),
        coded_(coded),
        notes_(notes),
        coarse_depth_(bands.depth(0) - half_octaves_of(scale)) {}

  void run() {
    code_coarse_depth();
    for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) code_coarse(s);
    std::fill_n(notes_.sums, coded_.signal_count, 0);
    std::fill_n(notes_.restless_signals, coded_.signal_count, 0);
    for (int s = 0; s < coded_.signal_count; ++s) {
      notes_.predictions[s].begin();
      notes_.rests[s].begin();
    }
    for (std::size_t scale = 0; scale < deviations_.size(); ++scale)
      deviations_[scale] = 26 + (1 << 24) / kInverseScales[scale];
    for (int b = 1; b < bands_.count; ++b) {
      std::swap(notes_.sums, notes_.sums_above);
      std::fill_n(notes_.sums, coded_.signal_count, 0);
      std::fill_n(notes_.activity, static_cast<std::size_t>(bands_[b].size) + 2, 0);
      begin_restless(b);
      for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) code_band(b, s);
    }
  }

 private:
  /// What is around a coefficient, in the terms of the contexts.
  struct Surroundings {
    int level;
    int own;       // size of the two before
    int above;     // size of the two parents
    int crowd;     // degree of what all signals so far did at that time
    int recent;    // degree of the running mean of the band
    int density;   // degree of the band above
    int expected;  // half octaves of a weighted sum of all
  };

  template <std::size_t count, std::size_t opinion_count = 0>
  bool code(bool bit, const std::array<int, count>& contexts, int set,
            const std::array<std::int32_t, opinion_count>& opinions = {}) {
    const auto at = static_cast<std::size_t>(set);
    MixingWeights* of_scale = nullptr;
    if constexpr (opinion_count > 0)
      of_scale = &model_.weights_by_scale[at][static_cast<std::size_t>(scale_step_)];
    std::array<AdaptiveBit*, count> believed;
    for (std::size_t i = 0; i < count; ++i) believed[i] = &context_at(contexts[i]);
    const Confidence* const confidence =
        confidences_[static_cast<std::size_t>(MixingSets::kind_of(set))].data();
    using Mixed = MixedBit<count, opinion_count>;
    Mixed mixed(believed, model_.weights[at], opinions, confidence, of_scale);
    bit = bits_.code(bit, mixed.one());
    mixed.follow(bit, Mixed::kSlower);
    note(bit, contexts, set, opinions);
    return bit;
  }

  template <std::size_t count>
  bool code(bool bit, const int (&contexts)[count], int set) {
    return code(bit, std::to_array(contexts), set);
  }

  template <std::size_t count>
  bool code(bool bit, const int (&contexts)[count], int set,
            const ExpectedValue::Opinions& opinions) {
    return code(bit, std::to_array(contexts), set, opinions);
  }

  bool code(bool bit, int context) {
    constexpr Probability kLeast = 64;
    AdaptiveBit& believed = context_at(context);
    bit = bits_.code(bit, std::clamp<Probability>(believed.one, kLeast, 65536 - kLeast));
    believed.follow(bit);
    note(bit, std::array{context}, -1, std::array<std::int32_t, 0>());
    return bit;
  }

  AdaptiveBit& context_at(int context) { return model_.contexts[context]; }

  template <std::size_t count, std::size_t opinion_count>
  void note(bool bit, const std::array<int, count>& contexts, int set,
            const std::array<std::int32_t, opinion_count>& opinions) {
    if constexpr (requires(const BitSources& sources) { bits_.note(sources, bit); }) {
      BitSources sources{{},
                         {},
                         static_cast<int>(count),
                         static_cast<int>(opinion_count),
                         set,
                         opinion_count > 0 ? scale_step_ : -1};
      std::copy(contexts.begin(), contexts.end(), sources.contexts.begin());
      std::copy(opinions.begin(), opinions.end(), sources.opinions.begin());
      bits_.note(sources, bit);
    }
  }

  /// Of v > 0, rounded down.
  static int half_octaves_of(float v) {
    return static_cast<int>(std::bit_cast<std::uint32_t>(v) >> 22) - 2 * 127;
  }

  /// Whole numbers in the terms of the contexts: three are 0 ... 15, the last 0 ... 31.
  struct Relations {
    int first, second, third, fourth;
  };

  /// Exp-Golomb: the digits of v + 1 in unary, then those below the first.
  int code_number(int v, int kind, const Relations& relations) {
    constexpr int kMostDigits = 30;
    const int wanted = digits_of(v + 1) - 1;
    int digits = 0;
    for (;; ++digits) {
      const int n = std::min(digits, 15);
      if (!code(digits < wanted,
                {at_.number_plain.at(kind, digits), at_.number_first.at(kind, relations.first, n),
                 at_.number_second.at(kind, relations.second, n),
                 at_.number_third.at(kind, relations.third, n),
                 at_.number_fourth.at(kind, relations.fourth, n)},
                MixingSets::kNumber + kind))
        break;
      if (digits == kMostDigits) {
        bits_.refuse();
        return 0;
      }
    }
    int number = 1;
    for (int d = digits - 1; d >= 0; --d) {
      const bool digit = ((v + 1) >> d & 1) != 0;
      const bool top = d == digits - 1;
      number = 2 * number +
               (top ? code(digit, at_.number_top.at(kind, digits)) : bits_.code(digit, kEvenOdds));
    }
    return number - 1;
  }

  int code_signed(int v, int kind, const Relations& relations) {
    const int folded = code_number(v > 0 ? 2 * v - 1 : -2 * v, kind, relations);
    return folded % 2 != 0 ? (folded + 1) / 2 : -(folded / 2);
  }

  void begin_restless(int b);
  void code_coarse_depth();
  void code_coarse(int s);
  bool code_significance(int b, int s, int density);
  int density_of(int b, int s) const;
  void code_band(int b, int s);
  int code_magnitude(int magnitude, int s, const Surroundings& around,
                     const ExpectedValue& expected);

  Bits& bits_;
  const SignalNeighbours* neighbours_;
  const Bands& bands_;
  CoefficientModel& model_;
  const ContextLayout& at_;
  const Confidences& confidences_ = confidences();
  const PredictionKernels& kernels_ = best_prediction();
  QuantisedView coded_;
  CoderNotes notes_;
  int coarse_depth_;     // of coarse samples whose step_exponent is 0, in half octaves
  int scale_step_ = -1;  // of the value in hand
  std::array<std::int32_t, kScales> deviations_;  // mean distances from predictions, 256ths
};

/// Half of what there was in the band above at that time.
template <typename Bits>
void CoefficientCoder<Bits>::begin_restless(int b) {
  const int size = bands_[b].size + 2;
  if (b == 1) {
    std::fill_n(notes_.restless, size, 0);
    return;
  }
  // From the end on, for what is read lies at or before what is written.
  const int upper = bands_[b - 1].size + 2;
  for (int at = size - 1; at >= 0; --at)
    notes_.restless[at] = notes_.restless[std::min((at + 1) / 2, upper - 1)] / 2;
}

template <typename Bits>
void CoefficientCoder<Bits>::code_coarse_depth() {
  constexpr int kMiddle = kFourthRelations / 2;
  int before = 0;  // how far the last one was from what was expected of it
  for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) {
    const SignalNeighbours& neighbours = neighbours_[s];
    const bool mirrored = neighbours.mirror >= 0;
    const int model = mirrored ? neighbours.mirror : s - 1;
    const int expected = model < 0 ? 0 : coded_.step_exponent[model];
    std::int32_t& step_exponent = coded_.step_exponent[s];
    const int beside =
        neighbours.sibling < 0
            ? 0
            : kMiddle + std::clamp(coded_.step_exponent[neighbours.sibling] - expected, 1 - kMiddle,
                                   kMiddle - 1);
    before = code_signed(step_exponent - expected, mirrored ? 1 : 0,
                         {neighbours.sibling == s - 1 ? 1 : 0, std::min(std::abs(before), 15),
                          8 + std::clamp(before, -7, 7), beside});
    step_exponent = expected + before;
    if (step_exponent < kLeastStepExponent || step_exponent > kMostStepExponent) bits_.refuse();
  }
}

template <typename Bits>
void CoefficientCoder<Bits>::code_coarse(int s) {
  const SignalNeighbours& neighbours = neighbours_[s];
  const auto difference = [&](int signal, int i) {
    const std::int32_t* const values = coded_.signal(signal);
    return values[i] - (i > 0 ? values[i - 1] : 0);
  };
  const auto size = [&](int signal, int i) {
    return signal < 0 ? 0 : std::min(1 + digits_of(std::abs(difference(signal, i))), 15);
  };
  std::int32_t* const own = coded_.signal(s);
  // In steps so fine numbers are as large as angles are.
  const int step_depth =
      std::clamp((coded_.step_exponent[s] + coarse_depth_) / 2 + 6, 0, kFourthRelations - 1);
  for (int i = 0; i < bands_[0].size && !bits_.failed(); ++i) {
    const int before = i > 0 ? own[i - 1] : 0;
    const int kind = (i == 0 ? 2 : 3) + (s < 3 ? 2 : 0);
    const int second = i == 0 ? size(neighbours.sibling, 0) : i == 1 ? 0 : size(s, i - 1);
    std::int32_t& value = own[i];
    value = before + code_signed(value - before, kind,
                                 {size(neighbours.mirror, i), second, size(s - 1, i), step_depth});
    if (std::abs(value) > kMostSteps) bits_.refuse();
  }
}

/// Whether a signal has anything but zeros in a band.
template <typename Bits>
bool CoefficientCoder<Bits>::code_significance(int b, int s, int density) {
  const Band& band = bands_[b];
  const SignalNeighbours& neighbours = neighbours_[s];
  const int level = std::min(bands_.count - 1 - b, kLevels - 1);
  const auto state = [&](int signal) { return signal < 0 ? 2 : notes_.sums[signal] > 0 ? 1 : 0; };
  const std::int32_t* const first = coded_.signal(s) + band.first;
  bool significant = false;
  if constexpr (Bits::kWrites)
    significant =
        std::any_of(first, first + band.size, [](std::int32_t value) { return value != 0; });
  return code(
      significant,
      {at_.significant_level.at(level, density),
       at_.significant_neighbours.at(state(neighbours.sibling), state(neighbours.mirror), density),
       at_.significant_length.at(level, std::min(digits_of(band.size), 7), density)},
      MixingSets::kSignificant);
}

/// How much there is in the band above, as a degree.
template <typename Bits>
int CoefficientCoder<Bits>::density_of(int b, int s) const {
  const int upper = bands_[b - 1].size;
  const std::int64_t sum = b > 1 ? notes_.sums_above[s] : upper;
  const auto mean = static_cast<int>(16 * sum / std::max(upper, 1));  // 16ths
  return sum == 0 ? 0 : std::min(1 + digits_of(mean), kDegrees - 1);
}

template <typename Bits>
void CoefficientCoder<Bits>::code_band(int b, int s) {
  const int density = density_of(b, s);
  if (!code_significance(b, s, density)) return;
  const Band& band = bands_[b];
  const Band& upper = bands_[b - 1];
  const bool has_parents = b > 1;
  const SignalNeighbours& neighbours = neighbours_[s];
  const auto column = [&](int of, const Band& in) {
    return of < 0 ? nullptr : coded_.signal(of) + in.first;
  };
  std::int32_t* const own = column(s, band);
  const std::int32_t* const parents = column(s, upper);
  const std::int32_t* const sibling = column(neighbours.sibling, band);
  const std::int32_t* const mirror = column(neighbours.mirror, band);
  const std::int32_t* const before = column(s - 2, band);
  const std::int32_t* const earlier = column(s - 3, band);
  const auto& weights =
      kScaleWeights[static_cast<std::size_t>(std::min(bands_.count - 1 - b, kScaleLevels - 1))];
  const auto at = [](const std::int32_t* values, int i, int size) {
    return values == nullptr || i < 0 || i >= size ? 0 : values[i];
  };
  const auto magnitude_at = [&](const std::int32_t* values, int i, int size) {
    return std::abs(at(values, i, size));
  };

  Surroundings around{};
  around.level = std::min(bands_.count - 1 - b, kLevels - 1);
  around.density = density;
  int recent = 0;  // 64ths
  constexpr int kMostPredicted = 2 * SignalPrediction::kFarthest;
  constexpr int kFurther = SignalPrediction::kTaps - 9;  // signals before: the first that least
                                                         // squares do not look at
  const int end_of_taps =
      std::min(RestPrediction::kTaps, SignalPrediction::kTaps + std::max(s + 1 - kFurther, 0));
  std::array<std::int32_t, RestPrediction::kTaps> around_it{};
  for (int i = 0; i < band.size && !bits_.failed(); ++i) {
    const int own1 = magnitude_at(own, i - 1, band.size);
    const int own2 = magnitude_at(own, i - 2, band.size);
    const int own3 = magnitude_at(own, i - 3, band.size);
    const int k = i / 2;  // the parent nearest in time, and the next
    const int l = i % 2 != 0 ? k + 1 : k - 1;
    const int above1 = has_parents ? magnitude_at(parents, k, upper.size) : 0;
    const int above2 = has_parents ? magnitude_at(parents, l, upper.size) : 0;
    const int beside = magnitude_at(sibling, i, band.size);
    int* const activity = notes_.activity + i + 1;
    const int busy = 2 * activity[0] + activity[-1] + activity[1];

    around.own = size_of(2 * own1 + own2);
    around.above = size_of(2 * above1 + above2);
    around.crowd = s == 0 ? 0 : degree_of(8 * busy / s);
    around.recent = degree_of(recent / 4);
    const auto capped = [](int magnitude) { return std::min(magnitude, 255); };
    around.expected = half_octave_of(20 * capped(own1) + 5 * capped(own2) + 3 * capped(own3) +
                                     7 * capped(above1) + 2 * capped(above2) + 7 * capped(beside) +
                                     14 * capped(magnitude_at(mirror, i, band.size)) +
                                     (s == 0 ? 0 : 16 * activity[0] / s) + recent / 4);

    int* const restless = notes_.restless + i + 1;
    int& restless_signal = notes_.restless_signals[s];
    const auto in_64ths = [](int magnitude) { return 64 * std::min(magnitude, 1 << 14); };
    const auto size_at = [&](const std::int32_t* values, int at_i, int size) {
      return in_64ths(magnitude_at(values, at_i, size));
    };
    const std::array<int, kScaleFeatures> features = {
        in_64ths(own1),
        in_64ths(own2),
        in_64ths(own3),
        in_64ths(above1),
        in_64ths(above2),
        has_parents ? size_at(parents, i % 2 != 0 ? k - 1 : k + 1, upper.size) : 0,
        size_at(sibling, i - 1, band.size),
        in_64ths(beside),
        size_at(sibling, i + 1, band.size),
        size_at(mirror, i - 1, band.size),
        size_at(mirror, i, band.size),
        size_at(mirror, i + 1, band.size),
        s == 0 ? 0 : 64 * activity[0] / s,
        s == 0 ? 0 : 64 * (activity[-1] + activity[1]) / s,
        recent,
        19,
        size_at(before, i, band.size),
        size_at(earlier, i, band.size)};
    std::int32_t weighted = 6 << 10;
    for (std::size_t f = 0; f < features.size(); ++f) weighted += weights[f] * features[f];
    const int unrest = restless_signal + (3 * restless[0] + restless[-1] + restless[1]) / 4;
    const int scale = std::clamp(
        kScaleOfOne +
            ((log2_256(static_cast<std::uint32_t>(weighted >> 10)) - 6 * 256 + unrest + 32) >> 6),
        0, kScales - 1);
    scale_step_ = MixingSets::scale_step(scale);
    const std::int32_t inverse = kInverseScales[static_cast<std::size_t>(scale)];
    around_it = {at(own, i - 1, band.size),
                 at(own, i - 2, band.size),
                 has_parents ? at(parents, k, upper.size) : 0,
                 has_parents ? at(parents, l, upper.size) : 0,
                 at(sibling, i - 1, band.size),
                 at(sibling, i, band.size),
                 at(sibling, i + 1, band.size),
                 at(mirror, i - 1, band.size),
                 at(mirror, i, band.size),
                 at(mirror, i + 1, band.size)};
    for (int t = 10, other = s - 1; t < SignalPrediction::kTaps; ++t, --other)
      around_it[static_cast<std::size_t>(t)] =
          other == neighbours.sibling ? 0 : at(column(other, band), i, band.size);
    std::ptrdiff_t further = std::ptrdiff_t{s - kFurther} * coded_.length + band.first + i;
    for (int t = SignalPrediction::kTaps; t < end_of_taps; ++t, further -= coded_.length)
      around_it[static_cast<std::size_t>(t)] = coded_.values[further];
    RestPrediction::Taps taps;
    kernels_.normalise(around_it, inverse, taps);
    SignalPrediction& prediction = notes_.predictions[s];
    RestPrediction& rest = notes_.rests[s];
    const int first_predicted = kernels_.of_signal(prediction, taps.data());
    const int rest_predicted = kernels_.of_rest(rest, taps);
    const int predicted =
        std::clamp(first_predicted + rest_predicted, -kMostPredicted, kMostPredicted);
    const int mean = predicted * 65536 / inverse;  // 64ths, at most 2^24
    std::int32_t& deviation = deviations_[static_cast<std::size_t>(scale)];
    ExpectedValue expected(mean, deviation);

    const auto less = expected.down_from_minus(1);
    const auto something = sum(expected.from(1), less);
    constexpr ExpectedValue::Shares kAll = {ExpectedValue::kWhole, ExpectedValue::kWhole};

    std::int32_t& value = own[i];
    const auto on_zero = ExpectedValue::opinions(something, kAll);
    const bool some =
        code(value != 0,
             {at_.zero_near.at(around.level, around.own, around.above),
              at_.zero_crowd.at(around.crowd, around.own, around.above),
              at_.zero_expected.at(around.level, around.expected), at_.zero_own.at(s, around.level),
              at_.zero_opinion.at(around.level, opinion_step(on_zero[0]))},
             MixingSets::kZero + around.level, on_zero);
    int magnitude = 0;
    if (some) {
      const int own1_sign = sign_of(at(own, i - 1, band.size));
      const int own2_sign = sign_of(at(own, i - 2, band.size));
      const int above1_sign = has_parents ? sign_of(at(parents, k, upper.size)) : 0;
      const int above2_sign = has_parents ? sign_of(at(parents, l, upper.size)) : 0;
      const int sibling_sign = sign_of(at(sibling, i, band.size));
      const auto on_sign = ExpectedValue::opinions(less, something);
      const bool minus =
          code(value < 0,
               {at_.sign_near.at(around.level, own1_sign * kSigns + own2_sign, above1_sign),
                at_.sign_above.at(above1_sign * kSigns + above2_sign, own1_sign, i % 2),
                at_.sign_neighbours.at(s, sibling_sign, sign_of(at(mirror, i, band.size))),
                at_.sign_before.at(s, sibling_sign, sign_of(at(before, i, band.size))),
                at_.sign_opinion.at(around.level, opinion_step(on_sign[0]))},
               MixingSets::kSign, on_sign);
      expected.fold(minus);
      magnitude = code_magnitude(std::abs(value), s, around, expected);
      value = minus ? -magnitude : magnitude;
    } else {
      value = 0;
    }
    if constexpr (requires(const ValueSources& sources) { bits_.note(sources); })
      bits_.note(ValueSources{features, around.level, unrest, mean, value});
    const std::int64_t distance = std::min<std::int64_t>(
        std::abs((static_cast<std::int64_t>(value) << 6) - mean), 1 << 20);  // 64ths
    deviation += static_cast<std::int32_t>((4 * distance - deviation) / 80);
    const auto excess = static_cast<int>(
        std::clamp<std::int64_t>((distance * inverse >> 14) - 256, -256, 512));  // 256ths
    restless[0] = std::clamp(restless[0] + 60 * excess / 256, -2048, 2048);
    restless_signal = std::clamp(restless_signal + 15 * excess / 256, -2048, 2048);
    const int left = normalised(value, inverse) - first_predicted;
    kernels_.signal_follows(prediction, taps.data(), left);
    kernels_.rest_follows(rest, taps, left - rest_predicted);
    recent += (64 * std::min(magnitude, 255) - recent) / 8;
    activity[0] += std::min(magnitude, 8);
    notes_.sums[s] += std::min(magnitude, 255);
  }
}

/// The number of digits in unary, then the digits below the first.
template <typename Bits>
int CoefficientCoder<Bits>::code_magnitude(int magnitude, int s, const Surroundings& around,
                                           const ExpectedValue& expected) {
  constexpr int kMostDigits = 29;  // kMostSteps has as many
  const int wanted = digits_of(magnitude);
  int digits = 1;
  auto all = expected.from(1);  // that are left, and those from the next digit on
  auto upper = expected.from(2);
  for (; digits < kMostDigits; ++digits) {
    const int k = std::min(digits, kClasses) - 1;
    const auto opinions = ExpectedValue::opinions(upper, all);
    if (!code(digits < wanted,
              {at_.class_recent.at(k, around.recent, around.density),
               at_.class_expected.at(k, around.expected), at_.class_own.at(s, k),
               at_.class_opinion.at(k, around.level, opinion_step(opinions[0]))},
              MixingSets::kClass + k, opinions))
      break;
    all = upper;
    upper = expected.from(std::int64_t{2} << digits);
  }
  const int k = std::min(digits, kClasses) - 1;
  int made = 1;
  all = difference(all, upper);
  for (int d = digits - 2; d >= 0; --d) {
    bool digit = (magnitude >> d & 1) != 0;
    const auto in_upper_half = difference(expected.from((2 * std::int64_t{made} + 1) << d), upper);
    const ExpectedValue::Opinions opinions = ExpectedValue::opinions(in_upper_half, all);
    const int step = opinion_step(opinions[0]);
    if (d == digits - 2)
      digit = code(
          digit,
          {at_.top_expected.at(k, around.expected), at_.top_recent.at(k, around.recent, around.own),
           at_.top_opinion.at(around.level, step)},
          MixingSets::kTop, opinions);
    else if (d == digits - 3)
      digit = code(digit,
                   {at_.next_digit.at(k, made & 1, around.expected / 4),
                    at_.next_opinion.at(around.level, step)},
                   MixingSets::kNext, opinions);
    else
      digit = code(digit, {at_.lower_opinion.at(around.level, step)}, MixingSets::kLower, opinions);
    made = 2 * made + digit;
    if (digit) {
      all = in_upper_half;
    } else {
      all = difference(all, in_upper_half);
      upper = sum(upper, in_upper_half);
    }
  }
  if (made > kMostSteps) bits_.refuse();
  return made;
}

}  // namespace mocapress::runtime
