// SPDX-License-Identifier: MIT
// What the adaptive coding knows beforehand, fitted to other clips by tests/bench/fit_priors.cpp.
// Part of the file format.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace mocapress::runtime {

/// One character for each shared context: the log odds of a set bit, a space where nothing was
/// seen.
std::string_view context_priors();

/// MixingWeights::kMost for each set, 1024 = once.
std::span<const std::int16_t> weight_priors();

/// Log odds in 256ths, -2048 ... 2048, of '#' ... '|' without the backslash: 44 steps either way.
constexpr std::optional<int> log_odds_of_prior(char letter) {
  if (letter == ' ') return std::nullopt;
  const int step = letter - '#' - (letter > '\\' ? 1 : 0);
  return (step - 44) * 512 / 11;
}

/// The inverse, of steps -44 ... 44 of 2 / 11 each.
constexpr char letter_of_prior(int steps) {
  const int letter = '#' + steps + 44;
  return static_cast<char>(letter >= '\\' ? letter + 1 : letter);
}

}  // namespace mocapress::runtime
