// SPDX-License-Identifier: MIT
// The adaptive coding of coefficients, shared by the encoder, the decoder and the code that
// measures sizes: FORMAT.md, "Adaptive coding".
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <utility>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/format/coefficient_model.h"
#include "core/runtime/format/coefficient_priors.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/signal_neighbours.h"
#include "core/runtime/format/value_prediction.h"

namespace mocapress::runtime {

inline constexpr int kLeastStepExponent = -128;
inline constexpr int kMostStepExponent = 127;
inline constexpr int kMostSteps = 1 << 28;      // largest magnitude of a coefficient
inline constexpr int kMostMagnitude = 255;      // larger magnitudes count as this in sums
inline constexpr int kLeastDeviation = 26;      // in 256ths of a quantisation step
inline constexpr int kLeastExpected = 6 << 10;  // smallest magnitude to expect, in units of 1 / (64
                                                // * 1024)
inline constexpr double kLargestStep = 0x1p64;  // larger steps are invalid, so that every sample is
                                                // finite

/// Quantised coefficients of some signals. The memory belongs to the caller.
struct QuantisedView {
  int length;  // coefficients of each signal, coarse to fine
  int signal_count;
  std::int32_t* step_exponent;  // for each signal: its step is scale * 2^(-step_exponent / 2)
  std::int32_t* values;         // signal after signal

  std::int32_t* signal(int s) const { return values + static_cast<std::ptrdiff_t>(s) * length; }
};

/// Working memory of a CoefficientCoder. "The band above" is the next coarser one.
struct CoderNotes {
  std::int64_t* sums;  // for each signal: sum of the magnitudes in the current band
  std::int64_t* sums_above;
  int* activity;  // for each time in the band, from coefficient -1 on: magnitudes of all signals so
                  // far, added up
  int* restless;  // for each time, as in `activity`: how much values exceed their expected scale,
                  // in 256ths of an octave
  std::size_t activity_size;
  int* restless_signals;          // the same for each signal, over time
  SignalPrediction* predictions;  // one for each signal
  RestPrediction* rests;          // one for each signal

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

/// Contexts and opinions from which a bit was predicted, for the note() of `Bits`.
struct BitSources {
  std::array<int, kMostContexts> contexts;
  std::array<std::int32_t, 2> opinions;
  int context_count;
  int opinion_count;
  int set;  // index of the mixing weights; -1: none, with a single context
};

/// A value, and the features from which its scale was estimated, for the note() of `Bits`.
struct ValueSources {
  std::array<int, kScaleFeatures> features;
  int level;
  int unrest;  // excess of nearby values over their scale, in 256ths of an octave
  int mean;    // predicted value, in 64ths of a step
  std::int32_t value;
};

/// Codes the coefficients of all signals in the order of the file. `Bits` is an encoder, which
/// writes the bits that it is given, or a decoder, which ignores them and returns the bits that it
/// reads. It has bool code(bool bit, Probability one); refuse(), called when a decoded number is
/// out of bounds; and failed(): if true, nothing that was decoded is of use. Decoded values are
/// written to `coded`, which must hold zeros before.
///
/// A `Bits` may have more functions. note(BitSources, bool) and note(ValueSources) are told what
/// each bit or value was predicted from. about(signal, band, value) is called before the bits of a
/// value; `value` is -1 before those of a whole band or signal.
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

  /// Codes all signals, but leaves out the values of the finest `bands_left_out` bands.
  void run(int bands_left_out = 0) {
    code_step_exponents();
    for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) code_coarse(s);
    std::fill_n(notes_.sums, coded_.signal_count, 0);
    std::fill_n(notes_.restless_signals, coded_.signal_count, 0);
    for (int s = 0; s < coded_.signal_count; ++s) {
      notes_.predictions[s].begin();
      notes_.rests[s].begin();
    }
    for (std::size_t scale = 0; scale < deviations_.size(); ++scale)
      deviations_[scale] = kLeastDeviation + (1 << 24) / kInverseScales[scale];
    for (int b = 1; b < bands_.count - bands_left_out; ++b) {
      std::swap(notes_.sums, notes_.sums_above);
      std::fill_n(notes_.sums, coded_.signal_count, 0);
      std::fill_n(notes_.activity, static_cast<std::size_t>(bands_[b].size) + 2, 0);
      begin_restless(b);
      for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) code_band(b, s);
    }
  }

 private:
  /// The signed values around value i in a band of a signal; 0 where there is none.
  struct Around {
    int own1, own2, own3;           // values i - 1, i - 2, i - 3
    int parent1, parent2, parent3;  // in the band above: the nearest in time, then the two beside
                                    // that one
    int sibling_before, sibling, sibling_after;  // values i - 1, i, i + 1 of the sibling
    int mirror_before, mirror, mirror_after;     // values i - 1, i, i + 1 of the mirror
    int before, earlier;                         // value i of signals s - 2 and s - 3
  };

  /// A band of a signal, the same band of neighbouring signals, and the band above; null where
  /// there is none.
  struct Columns {
    int signal;
    int level;
    int density;  // density_of() the band above
    int first;    // index of the band's first value in the signal
    int size;
    int parent_size;  // size of the band above; 0 in the first band of details
    std::int32_t* own;
    const std::int32_t* parents;
    const std::int32_t* sibling;
    const std::int32_t* mirror;
    const std::int32_t* before;
    const std::int32_t* earlier;

    int at(const std::int32_t* values, int i) const {
      return values == nullptr || i < 0 || i >= size ? 0 : values[i];
    }
    int parent(int i) const { return i < 0 || i >= parent_size ? 0 : parents[i]; }
    Around around(int i) const {
      const int nearest = i / 2;
      const int after = i % 2 != 0 ? 1 : -1;
      return {at(own, i - 1),     at(own, i - 2),          at(own, i - 3),
              parent(nearest),    parent(nearest + after), parent(nearest - after),
              at(sibling, i - 1), at(sibling, i),          at(sibling, i + 1),
              at(mirror, i - 1),  at(mirror, i),           at(mirror, i + 1),
              at(before, i),      at(earlier, i)};
    }
  };

  /// The values around a value, summarised as indices of contexts.
  struct Surroundings {
    int own;       // size_of() the two values before
    int above;     // size_of() the two nearest parents
    int crowd;     // degree_of() the mean activity of the earlier signals around that time
    int recent;    // degree_of() the running mean of magnitudes in the band
    int expected;  // half_octave_of() a weighted sum of the magnitudes
  };

  /// The scale (typical magnitude) that is expected of a value, and the sources of that estimate.
  struct ExpectedScale {
    std::array<int, kScaleFeatures> features{};
    int unrest = 0;            // excess of nearby values, in 256ths of an octave
    int scale = 0;             // 0 ... kScales - 1
    std::int32_t inverse = 0;  // 65536 / the magnitude that `scale` stands for
  };

  /// The prediction of a value as a weighted sum of other values, which are called taps.
  struct Predicted {
    RestPrediction::Taps taps;
    int by_squares;  // prediction by least squares, in 64ths of the expected scale
    int rest;
    int mean;  // sum of by_squares and rest, in 64ths of a step
  };

  template <std::size_t count, std::size_t opinion_count = 0>
  bool code(bool bit, const std::array<int, count>& contexts, int set,
            const std::array<std::int32_t, opinion_count>& opinions = {}) {
    std::array<AdaptiveBit*, count> believed;
    for (std::size_t i = 0; i < count; ++i) believed[i] = &context_at(contexts[i]);
    using Mixed = MixedBit<count, opinion_count>;
    Mixed mixed(believed, model_.weights[static_cast<std::size_t>(set)], opinions);
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
      BitSources sources{{}, {}, static_cast<int>(count), static_cast<int>(opinion_count), set};
      std::copy(contexts.begin(), contexts.end(), sources.contexts.begin());
      std::copy(opinions.begin(), opinions.end(), sources.opinions.begin());
      bits_.note(sources, bit);
    }
  }

  void about(int signal, int band, int value) {
    if constexpr (requires { bits_.about(signal, band, value); }) bits_.about(signal, band, value);
  }

  /// 2 * log2(v) for v > 0, rounded down; linear between powers of two.
  static int half_octaves_of(float v) {
    return static_cast<int>(bit_pattern<std::uint32_t>(v) >> 22) - 2 * 127;
  }

  /// Facts that are known before a number is coded, as indices of contexts. The first three are 0
  /// ... 15, the fourth 0 ... 31.
  struct Relations {
    int first, second, third, fourth;
  };

  /// Codes v >= 0 by an Exp-Golomb code: first, in unary, the number of binary digits of v + 1 less
  /// one; then the digits after the first.
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
  void code_step_exponents();
  void code_coarse(int s);
  bool code_significance(int b, int s, int density);
  int density_of(int b, int s) const;
  Columns columns_of(int b, int s, int density) const;
  void code_band(int b, int s);
  Surroundings surroundings_of(const Columns& band, int i, const Around& around) const;
  ExpectedScale expected_scale(const Columns& band, int i, const Around& around) const;
  Predicted predict(const Columns& band, int i, const Around& around, std::int32_t inverse);
  int code_value(int value, const Columns& band, int i, const Around& around,
                 const Surroundings& near, ExpectedValue expected);
  int code_magnitude(int magnitude, const Columns& band, const Surroundings& near,
                     const ExpectedValue& expected);
  void follow(int value, const Columns& band, int i, const ExpectedScale& scale,
              const Predicted& predicted);

  Bits& bits_;
  const SignalNeighbours* neighbours_;
  const Bands& bands_;
  CoefficientModel& model_;
  const ContextLayout& at_;
  const PredictionKernels& kernels_ = best_prediction();
  QuantisedView coded_;
  CoderNotes notes_;
  int coarse_depth_;  // the coarse samples of a signal with step_exponent 0 have the step
                      // 2^(-coarse_depth_ / 2)
  int recent_ = 0;    // running mean of the magnitudes in the current band, in 64ths
  std::array<std::int32_t, kScales> deviations_;  // for each scale: mean distance of values from
                                                  // their predictions, in 256ths of a step
};

/// Sets the first values of `restless` for a band: half of those of the band above at the same
/// time.
template <typename Bits>
void CoefficientCoder<Bits>::begin_restless(int b) {
  const int size = bands_[b].size + 2;
  if (b == 1) {
    std::fill_n(notes_.restless, size, 0);
    return;
  }
  // Goes backwards: each new value is made from an old one at its own place or before, which is not
  // overwritten yet.
  const int upper = bands_[b - 1].size + 2;
  for (int at = size - 1; at >= 0; --at)
    notes_.restless[at] = notes_.restless[std::min((at + 1) / 2, upper - 1)] / 2;
}

template <typename Bits>
void CoefficientCoder<Bits>::code_step_exponents() {
  int before = 0;  // the previous signal's step_exponent less its prediction
  for (int s = 0; s < coded_.signal_count && !bits_.failed(); ++s) {
    const SignalNeighbours& neighbours = neighbours_[s];
    const bool mirrored = neighbours.mirror >= 0;
    const int model = mirrored ? neighbours.mirror : s - 1;
    const int expected = model < 0 ? 0 : coded_.step_exponent[model];
    std::int32_t& step_exponent = coded_.step_exponent[s];
    about(s, 0, -1);
    before = code_signed(step_exponent - expected, mirrored ? 1 : 0,
                         {neighbours.sibling == s - 1 ? 1 : 0, std::min(std::abs(before), 15),
                          8 + std::clamp(before, -7, 7), 0});
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
  // Finer steps make larger numbers likely, so the depth of the step selects the context.
  const int step_depth =
      std::clamp((coded_.step_exponent[s] + coarse_depth_) / 2 + 6, 0, kFourthRelations - 1);
  for (int i = 0; i < bands_[0].size && !bits_.failed(); ++i) {
    const int before = i > 0 ? own[i - 1] : 0;
    const int kind = (i == 0 ? 2 : 3) + (s < 3 ? 2 : 0);
    const int second = i == 0 ? size(neighbours.sibling, 0) : i == 1 ? 0 : size(s, i - 1);
    std::int32_t& value = own[i];
    about(s, 0, i);
    value = before + code_signed(value - before, kind,
                                 {size(neighbours.mirror, i), second, size(s - 1, i), step_depth});
    if (std::abs(value) > kMostSteps) bits_.refuse();
  }
}

/// Codes whether a signal has a nonzero value in a band, and returns the answer.
template <typename Bits>
bool CoefficientCoder<Bits>::code_significance(int b, int s, int density) {
  about(s, b, -1);
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

/// The density of the band above: 0 if all of its values are zero, else 1 + the number of binary
/// digits of its mean magnitude in 16ths.
template <typename Bits>
int CoefficientCoder<Bits>::density_of(int b, int s) const {
  const int upper = bands_[b - 1].size;
  const std::int64_t sum = b > 1 ? notes_.sums_above[s] : upper;
  const auto mean = static_cast<int>(16 * sum / std::max(upper, 1));  // in 16ths
  return sum == 0 ? 0 : std::min(1 + digits_of(mean), kDegrees - 1);
}

template <typename Bits>
typename CoefficientCoder<Bits>::Columns CoefficientCoder<Bits>::columns_of(int b, int s,
                                                                            int density) const {
  const Band& band = bands_[b];
  const Band& upper = bands_[b - 1];
  const bool has_parents = b > 1;
  const auto column = [&](int signal, const Band& in) {
    return signal < 0 ? nullptr : coded_.signal(signal) + in.first;
  };
  const SignalNeighbours& neighbours = neighbours_[s];
  return {.signal = s,
          .level = std::min(bands_.count - 1 - b, kLevels - 1),
          .density = density,
          .first = band.first,
          .size = band.size,
          .parent_size = has_parents ? upper.size : 0,
          .own = column(s, band),
          .parents = column(s, upper),
          .sibling = column(neighbours.sibling, band),
          .mirror = column(neighbours.mirror, band),
          .before = column(s - 2, band),
          .earlier = column(s - 3, band)};
}

template <typename Bits>
void CoefficientCoder<Bits>::code_band(int b, int s) {
  const int density = density_of(b, s);
  if (!code_significance(b, s, density)) return;
  const Columns band = columns_of(b, s, density);
  recent_ = 0;
  for (int i = 0; i < band.size && !bits_.failed(); ++i) {
    about(s, b, i);
    const Around around = band.around(i);
    const ExpectedScale scale = expected_scale(band, i, around);
    const Predicted predicted = predict(band, i, around, scale.inverse);
    const ExpectedValue expected(predicted.mean,
                                 deviations_[static_cast<std::size_t>(scale.scale)]);
    std::int32_t& value = band.own[i];
    value = code_value(value, band, i, around, surroundings_of(band, i, around), expected);
    if constexpr (requires(const ValueSources& sources) { bits_.note(sources); })
      bits_.note(ValueSources{scale.features, band.level, scale.unrest, predicted.mean, value});
    follow(value, band, i, scale, predicted);
  }
}

template <typename Bits>
typename CoefficientCoder<Bits>::Surroundings CoefficientCoder<Bits>::surroundings_of(
    const Columns& band, int i, const Around& around) const {
  const auto magnitude = [](int value) { return std::min(std::abs(value), kMostMagnitude); };
  const int* const activity = notes_.activity + i + 1;
  const int s = band.signal;
  const int busy = 2 * activity[0] + activity[-1] + activity[1];
  // An estimate of the magnitude in 64ths: each neighbour weighted by how well it predicts.
  const int expected = 20 * magnitude(around.own1) + 5 * magnitude(around.own2) +
                       3 * magnitude(around.own3) + 7 * magnitude(around.parent1) +
                       2 * magnitude(around.parent2) + 7 * magnitude(around.sibling) +
                       14 * magnitude(around.mirror) + (s == 0 ? 0 : 16 * activity[0] / s) +
                       recent_ / 4;
  return {.own = size_of(2 * std::abs(around.own1) + std::abs(around.own2)),
          .above = size_of(2 * std::abs(around.parent1) + std::abs(around.parent2)),
          .crowd = s == 0 ? 0 : degree_of(8 * busy / s),
          .recent = degree_of(recent_ / 4),
          .expected = half_octave_of(expected)};
}

template <typename Bits>
typename CoefficientCoder<Bits>::ExpectedScale CoefficientCoder<Bits>::expected_scale(
    const Columns& band, int i, const Around& around) const {
  constexpr int kMostFeature = 1 << 14;
  constexpr int kAlwaysThere = 19;  // a constant feature, in 64ths
  const auto in_64ths = [&](int value) { return 64 * std::min(std::abs(value), kMostFeature); };
  const int* const activity = notes_.activity + i + 1;
  const int* const restless = notes_.restless + i + 1;
  const int s = band.signal;
  ExpectedScale expected{
      .features = {
          in_64ths(around.own1), in_64ths(around.own2), in_64ths(around.own3),
          in_64ths(around.parent1), in_64ths(around.parent2), in_64ths(around.parent3),
          in_64ths(around.sibling_before), in_64ths(around.sibling), in_64ths(around.sibling_after),
          in_64ths(around.mirror_before), in_64ths(around.mirror), in_64ths(around.mirror_after),
          s == 0 ? 0 : 64 * activity[0] / s, s == 0 ? 0 : 64 * (activity[-1] + activity[1]) / s,
          recent_, kAlwaysThere, in_64ths(around.before), in_64ths(around.earlier)}};
  const auto& weights = kScaleWeights[static_cast<std::size_t>(band.level)];
  std::int32_t magnitude = kLeastExpected;  // in units of 1 / (64 * 1024)
  for (std::size_t f = 0; f < weights.size(); ++f) magnitude += weights[f] * expected.features[f];
  expected.unrest = notes_.restless_signals[s] + (3 * restless[0] + restless[-1] + restless[1]) / 4;
  constexpr int kLog2Of64 = 6 * 256;
  const int octaves_256 =
      log2_256(static_cast<std::uint32_t>(magnitude >> 10)) - kLog2Of64 + expected.unrest;
  expected.scale = std::clamp(kScaleOfOne + ((octaves_256 + 32) >> 6), 0, kScales - 1);
  expected.inverse = kInverseScales[static_cast<std::size_t>(expected.scale)];
  return expected;
}

template <typename Bits>
typename CoefficientCoder<Bits>::Predicted CoefficientCoder<Bits>::predict(const Columns& band,
                                                                           int i,
                                                                           const Around& around,
                                                                           std::int32_t inverse) {
  constexpr int kMost = 2 * SignalPrediction::kFarthest;
  constexpr int kNearTaps = 10;  // values of the signal itself, its parents, sibling and mirror
  // Signals this far before, or further, are taps of the RestPrediction only.
  constexpr int kFurther = SignalPrediction::kTaps - kNearTaps + 1;
  const int s = band.signal;
  std::array<std::int32_t, RestPrediction::kTaps> values{
      around.own1,           around.own2,        around.parent1,       around.parent2,
      around.sibling_before, around.sibling,     around.sibling_after, around.mirror_before,
      around.mirror,         around.mirror_after};
  for (int t = kNearTaps, other = s - 1; t < SignalPrediction::kTaps && other >= 0; ++t, --other)
    if (other != neighbours_[s].sibling)
      values[static_cast<std::size_t>(t)] = coded_.signal(other)[band.first + i];
  for (int t = SignalPrediction::kTaps, other = s - kFurther;
       t < RestPrediction::kTaps && other >= 0; ++t, --other)
    values[static_cast<std::size_t>(t)] = coded_.signal(other)[band.first + i];
  Predicted predicted;
  kernels_.normalise(values, inverse, predicted.taps);
  predicted.by_squares = kernels_.of_signal(notes_.predictions[s], predicted.taps.data());
  predicted.rest = kernels_.of_rest(notes_.rests[s], predicted.taps);
  const int both = std::clamp(predicted.by_squares + predicted.rest, -kMost, kMost);
  predicted.mean = both * 65536 / inverse;  // at most 2^24
  return predicted;
}

template <typename Bits>
int CoefficientCoder<Bits>::code_value(int value, const Columns& band, int i, const Around& around,
                                       const Surroundings& near, ExpectedValue expected) {
  const int s = band.signal;
  const auto below_zero = expected.down_from_minus(1);
  const auto not_zero = sum(expected.from(1), below_zero);
  constexpr ExpectedValue::Shares kAll = {ExpectedValue::kWhole, ExpectedValue::kWhole};
  const bool some =
      code(value != 0,
           {at_.zero_near.at(band.level, near.own, near.above),
            at_.zero_crowd.at(near.crowd, near.own, near.above),
            at_.zero_expected.at(band.level, near.expected), at_.zero_own.at(s, band.level)},
           MixingSets::kZero + band.level, ExpectedValue::opinions(not_zero, kAll));
  if (!some) return 0;
  const int own1 = sign_of(around.own1);
  const int parent1 = sign_of(around.parent1);
  const int sibling = sign_of(around.sibling);
  const bool minus =
      code(value < 0,
           {at_.sign_near.at(band.level, own1 * kSigns + sign_of(around.own2), parent1),
            at_.sign_above.at(parent1 * kSigns + sign_of(around.parent2), own1, i % 2),
            at_.sign_neighbours.at(s, sibling, sign_of(around.mirror)),
            at_.sign_before.at(s, sibling, sign_of(around.before))},
           MixingSets::kSign, ExpectedValue::opinions(below_zero, not_zero));
  expected.fold(minus);
  const int magnitude = code_magnitude(std::abs(value), band, near, expected);
  return minus ? -magnitude : magnitude;
}

/// Codes a magnitude: first the number of its binary digits in unary, then the digits after the
/// first.
template <typename Bits>
int CoefficientCoder<Bits>::code_magnitude(int magnitude, const Columns& band,
                                           const Surroundings& near,
                                           const ExpectedValue& expected) {
  constexpr int kMostDigits = 29;  // number of binary digits of kMostSteps
  const int wanted = digits_of(magnitude);
  int digits = 1;
  auto all = expected.from(1);  // probabilities of the magnitudes that are still possible and, in
                                // `upper`, of those with more digits
  auto upper = expected.from(2);
  for (; digits < kMostDigits; ++digits) {
    const int k = std::min(digits, kClasses) - 1;
    if (!code(digits < wanted,
              {at_.class_recent.at(k, near.recent, band.density),
               at_.class_expected.at(k, near.expected), at_.class_own.at(band.signal, k)},
              MixingSets::kClass + k, ExpectedValue::opinions(upper, all)))
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
    const auto opinions = ExpectedValue::opinions(in_upper_half, all);
    if (d == digits - 2)
      digit =
          code(digit,
               {at_.top_expected.at(k, near.expected), at_.top_recent.at(k, near.recent, near.own)},
               MixingSets::kTop, opinions);
    else if (d == digits - 3)
      digit = code(digit, {at_.next_digit.at(k, made & 1, near.expected / 4)}, MixingSets::kNext,
                   opinions);
    else
      digit = code(digit, std::array<int, 0>(), MixingSets::kLower, opinions);
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

/// Lets all predictions and statistics learn from a value that was just coded.
template <typename Bits>
void CoefficientCoder<Bits>::follow(int value, const Columns& band, int i,
                                    const ExpectedScale& scale, const Predicted& predicted) {
  constexpr std::int64_t kMostDistance = 1 << 20;  // in 64ths of a step
  constexpr int kDeviationMemory = 80;             // length of the running mean, in values
  constexpr int kRestlessRate = 60;                // in 256ths
  constexpr int kRestlessRateOfSignal = 15;
  constexpr int kMostRestless = 2048;
  constexpr int kRecentMemory = 8;  // length of the running mean in values
  constexpr int kMostActivity = 8;  // largest contribution of one value
  const int s = band.signal;
  const std::int64_t distance = std::min<std::int64_t>(
      std::abs((static_cast<std::int64_t>(value) << 6) - predicted.mean), kMostDistance);
  std::int32_t& deviation = deviations_[static_cast<std::size_t>(scale.scale)];
  deviation += static_cast<std::int32_t>((4 * distance - deviation) / kDeviationMemory);

  const auto excess = static_cast<int>(
      std::clamp<std::int64_t>((distance * scale.inverse >> 14) - 256, -256, 512));  // 256ths
  const auto grow = [&](int& restless, int rate) {
    restless = std::clamp(restless + rate * excess / 256, -kMostRestless, kMostRestless);
  };
  grow(notes_.restless[i + 1], kRestlessRate);
  grow(notes_.restless_signals[s], kRestlessRateOfSignal);

  const int left = normalised(value, scale.inverse) - predicted.by_squares;
  kernels_.signal_follows(notes_.predictions[s], predicted.taps.data(), left);
  kernels_.rest_follows(notes_.rests[s], predicted.taps, left - predicted.rest);

  const int magnitude = std::abs(value);
  recent_ += (64 * std::min(magnitude, kMostMagnitude) - recent_) / kRecentMemory;
  notes_.activity[i + 1] += std::min(magnitude, kMostActivity);
  notes_.sums[s] += std::min(magnitude, kMostMagnitude);
}

}  // namespace mocapress::runtime
