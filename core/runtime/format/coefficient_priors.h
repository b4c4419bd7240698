// SPDX-License-Identifier: MIT
// What the adaptive coding knows beforehand, fitted to other clips by tests/bench/fit_priors.cpp.
// Part of the file format.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/runtime/format/coefficient_model.h"

namespace mocapress::runtime {

/// One character for each shared context: the log odds of a set bit, a space where nothing was
/// seen.
std::string_view context_priors();

/// One character for each: how many observations its log odds are worth.
std::string_view context_trust();

/// MixingWeights::kMost for each set, 1024 = once.
std::span<const std::int16_t> weight_priors();

/// The same for each step of the scale, of each set that has them.
std::span<const std::int16_t> weight_priors_by_scale();

/// How far each context counts.
const Confidences& confidences();

/// Log odds in 256ths, -2048 ... 2048, of '#' ... '|' without the backslash: 44 steps either way.
constexpr std::optional<int> log_odds_of_prior(char letter) {
  if (letter == ' ') return std::nullopt;
  const int step = letter - '#' - (letter > '\\' ? 1 : 0);
  return (step - 44) * 512 / 11;
}

/// Observations of 'a' ... 'l'.
inline constexpr std::array<std::uint16_t, 12> kTrusts = {3,  5,  8,  12,  18,  26,
                                                          40, 60, 90, 130, 180, 240};
constexpr std::uint16_t observations_of(char letter) {
  return letter < 'a' ? 0 : kTrusts[static_cast<std::size_t>(letter - 'a')];
}

/// The inverse of log_odds_of_prior(), of steps -44 ... 44 of 2 / 11 each.
constexpr char letter_of_prior(int steps) {
  const int letter = '#' + steps + 44;
  return static_cast<char>(letter >= '\\' ? letter + 1 : letter);
}

}  // namespace mocapress::runtime
