// SPDX-License-Identifier: MIT
// Initial probabilities of the adaptive coding, fitted to training clips by
// tests/bench/fit_priors.cpp. Part of the file format.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/runtime/format/coefficient_model.h"

namespace mocapress::runtime {

/// One character per shared context: the log odds of a set bit. A space stands for a context that
/// never occurred in training.
std::string_view context_priors();

/// One character per shared context: the number of observations that its log odds are worth.
std::string_view context_trust();

/// Initial mixing weights, MixingWeights::kMost per set; 1024 = 1.0.
std::span<const std::int16_t> weight_priors();

/// Decodes a character to log odds in 256ths, -2048 ... 2048. The characters '#' ... '|', without
/// the backslash, stand for 89 equal steps.
constexpr std::optional<int> log_odds_of_prior(char letter) {
  if (letter == ' ') return std::nullopt;
  const int step = letter - '#' - (letter > '\\' ? 1 : 0);
  return (step - 44) * 512 / 11;
}

/// The observation counts that the letters 'a' ... 'l' stand for.
inline constexpr std::array<std::uint16_t, 12> kTrusts = {3,  5,  8,  12,  18,  26,
                                                          40, 60, 90, 130, 180, 240};
constexpr std::uint16_t observations_of(char letter) {
  return letter < 'a' ? 0 : kTrusts[static_cast<std::size_t>(letter - 'a')];
}

/// Inverse of log_odds_of_prior(). `steps` is -44 ... 44, in steps of 2/11 (natural log odds).
constexpr char letter_of_prior(int steps) {
  const int letter = '#' + steps + 44;
  return static_cast<char>(letter >= '\\' ? letter + 1 : letter);
}

}  // namespace mocapress::runtime
