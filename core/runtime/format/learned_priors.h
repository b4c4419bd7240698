// SPDX-License-Identifier: MIT
// What clips of a packed bank taught, in place of what the adaptive coding knows of all clips:
// FORMAT.md, "PRIO".
#pragma once

#include <array>
#include <cstdint>

#include "core/runtime/format/coefficient_model.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

/// Of a context one byte: 32 log odds, and how many observations they are worth.
inline constexpr int kLearnedSteps = 32;
inline constexpr std::array<std::uint16_t, 8> kLearnedTrusts = {3, 5, 8, 14, 26, 50, 100, 240};

/// In 256ths, -2046 ... 2046, half a nat apart.
constexpr int learned_log_odds(std::uint8_t code) {
  return (2 * (code % kLearnedSteps) - (kLearnedSteps - 1)) * 66;
}
constexpr std::uint16_t learned_trust(std::uint8_t code) {
  return kLearnedTrusts[code / kLearnedSteps];
}

/// What a change of a mixing weight is told in: 65536 = once.
inline constexpr int kLearnedWeightStep = 65536 / 32;

/// Whether `learn` would take all of it.
mcpr_result check_learned(const Bytes& learned);

/// Changes what a model knows before the first bit; no bytes change nothing. Contexts of single
/// signals are taken up where the clip has as many signals as those that taught.
mcpr_result learn(const Bytes& learned, CoefficientModel& model);

}  // namespace mocapress::runtime
