// SPDX-License-Identifier: MIT
// The contexts of the adaptive coding: FORMAT.md, "Adaptive coding".
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string_view>

#include "core/runtime/format/mixed_bit.h"
#include "core/runtime/format/value_prediction.h"

namespace mocapress::runtime {

/// A block of contexts with up to three indices.
struct ContextTable {
  int first = 0;
  int second_size = 1;
  int third_size = 1;

  constexpr int at(int i, int j = 0, int k = 0) const {
    return first + (i * second_size + j) * third_size + k;
  }
};

inline constexpr int kLevels = 8;         // of bands; level 0 is the finest
inline constexpr int kSizes = 8;          // results of size_of()
inline constexpr int kDegrees = 10;       // results of degree_of()
inline constexpr int kExpectations = 32;  // results of half_octave_of()
inline constexpr int kClasses = 8;  // numbers of binary digits in a magnitude: 1 ... 7, 8 or more
inline constexpr int kNumberKinds = 6;
inline constexpr int kNumberRelations = 16;
inline constexpr int kFourthRelations = 32;
inline constexpr int kSigns = 3;

/// The index of each context. Contexts before `shared` serve all signals, and start from priors
/// that were fitted to other clips. The others belong to single signals.
struct ContextLayout {
  ContextTable zero_near, zero_crowd, zero_expected;
  ContextTable class_recent, class_expected;
  ContextTable top_expected, top_recent, next_digit;
  ContextTable sign_near, sign_above;
  ContextTable significant_level, significant_neighbours, significant_length;
  ContextTable number_plain, number_first, number_second, number_third, number_top;
  ContextTable number_fourth;
  int shared = 0;
  ContextTable zero_own, class_own, sign_neighbours, sign_before;
  int end = 0;

  explicit constexpr ContextLayout(int signal_count) {
    const auto table = [this](int i, int j = 1, int k = 1) {
      const ContextTable made{end, j, k};
      end += i * j * k;
      return made;
    };
    zero_near = table(kLevels, kSizes, kSizes);
    zero_crowd = table(kDegrees, kSizes, kSizes);
    zero_expected = table(kLevels, kExpectations);
    class_recent = table(kClasses, kDegrees, kDegrees);
    class_expected = table(kClasses, kExpectations);
    top_expected = table(kClasses, kExpectations);
    top_recent = table(kClasses, kDegrees, kSizes);
    next_digit = table(kClasses, 2, 8);
    sign_near = table(kLevels, kSigns * kSigns, kSigns);
    sign_above = table(kSigns * kSigns, kSigns, 2);
    significant_level = table(kLevels, kDegrees);
    significant_neighbours = table(3, 3, kDegrees);
    significant_length = table(kLevels, 8, kDegrees);
    number_plain = table(kNumberKinds, 32);
    number_first = table(kNumberKinds, kNumberRelations, 16);
    number_second = table(kNumberKinds, kNumberRelations, 16);
    number_third = table(kNumberKinds, kNumberRelations, 16);
    number_top = table(kNumberKinds, 32);
    number_fourth = table(kNumberKinds, kFourthRelations, 16);
    shared = end;
    zero_own = table(signal_count, kLevels);
    class_own = table(signal_count, kClasses);
    sign_neighbours = table(signal_count, kSigns, kSigns);
    sign_before = table(signal_count, kSigns, kSigns);
  }
};

/// Indices of the sets of mixing weights. Each kind of coded bit has a set.
struct MixingSets {
  static constexpr int kSignificant = 0;
  static constexpr int kZero = 1;                 // one per level
  static constexpr int kClass = kZero + kLevels;  // one per class
  static constexpr int kTop = kClass + kClasses;
  static constexpr int kSign = kTop + 1;
  static constexpr int kNumber = kSign + 1;  // one per kind of number
  static constexpr int kNext = kNumber + kNumberKinds;
  static constexpr int kLower = kNext + 1;
  static constexpr int kCount = kLower + 1;
};

inline constexpr int kMostContexts = 5;  // contexts that predict one bit

/// Everything that the adaptive coding has learned so far. `contexts` has layout.end elements,
/// whose memory belongs to the caller.
struct CoefficientModel {
  CoefficientModel(int signal_count, AdaptiveBit* memory)
      : layout(signal_count), contexts(memory) {}

  /// Starts from the priors in coefficient_priors.cpp.
  void begin();

  /// Starts without priors, in order to fit them.
  void begin_untaught();

  /// Sets contexts to priors in the form of context_priors() and context_trust().
  void teach(std::string_view priors, std::string_view trust);

  ContextLayout layout;
  AdaptiveBit* contexts;
  std::array<MixingWeights, MixingSets::kCount> weights;
};

/// Number of binary digits of v >= 0.
inline int digits_of(int v) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(v)));
}

/// Maps a sum of neighbouring magnitudes to a class 0 ... 7.
inline int size_of(int sum) {
  constexpr std::array<std::uint8_t, 16> kSmall = {0, 1, 2, 3, 3, 4, 4, 4, 5, 5, 5, 5, 5, 5, 6, 6};
  return sum < 16 ? kSmall[static_cast<std::size_t>(sum)] : sum < 40 ? 6 : 7;
}

/// Number of binary digits of v >= 0, at most 9.
inline int degree_of(int v) {
  return std::min(digits_of(v), kDegrees - 1);
}

/// Maps v >= 0 to 0 ... 31, on a logarithmic scale with two steps per octave.
inline int half_octave_of(int v) {
  const int digits = digits_of(v);
  return v < 2 ? v : std::min(2 * digits - 2 + (v >> (digits - 2) & 1), kExpectations - 1);
}

/// Maps zero, minus and plus to 0, 1 and 2.
inline int sign_of(int v) {
  return v > 0 ? 2 : v < 0 ? 1 : 0;
}

}  // namespace mocapress::runtime
