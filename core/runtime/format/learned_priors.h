// SPDX-License-Identifier: MIT
// Priors learned from the clips of a packed bank, which replace the general ones of
// coefficient_priors.h: FORMAT.md, "PRIO".
#pragma once

#include <array>
#include <cstdint>

#include "core/runtime/format/coefficient_model.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

/// A context is stored in one byte: one of 32 log odds, and the number of observations that they
/// are worth.
inline constexpr int kLearnedSteps = 32;
inline constexpr std::array<std::uint16_t, 8> kLearnedTrusts = {3, 5, 8, 14, 26, 50, 100, 240};

/// Decodes log odds, in 256ths: -2046 ... 2046, in steps of about half a nat.
constexpr int learned_log_odds(std::uint8_t code) {
  return (2 * (code % kLearnedSteps) - (kLearnedSteps - 1)) * 66;
}
constexpr std::uint16_t learned_trust(std::uint8_t code) {
  return kLearnedTrusts[code / kLearnedSteps];
}

/// Unit in which PRIO stores the changes of mixing weights; 65536 stands for 1.0.
inline constexpr int kLearnedWeightStep = 65536 / 32;

/// Checks that learn() would accept all of the bytes.
mcpr_result check_learned(const Bytes& learned);

/// Applies learned priors to a model that has not coded a bit yet. Empty `learned` changes nothing.
/// Contexts of single signals are applied only if the clip has as many signals as the clips that
/// the priors were learned from.
mcpr_result learn(const Bytes& learned, CoefficientModel& model);

}  // namespace mocapress::runtime
