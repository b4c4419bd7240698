// SPDX-License-Identifier: MIT
// Fits the priors of the adaptive coding to clips: first the prior of each context by itself, by
// how much the clips agree; then log odds and mixing weights together, by the gradient of the coded
// bits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/codec/format/adaptive.h"

namespace mocapress {

/// A coded bit and the contexts that predicted it.
struct NotedBit {
  std::array<std::uint32_t, runtime::kMostContexts> contexts;
  std::array<std::int16_t, 2> opinions;
  std::int8_t set;  // number of the set of weights; -1: predicted by one context alone
  std::uint8_t context_count : 4;
  std::uint8_t opinion_count : 3;
  std::uint8_t bit : 1;
};

/// All bits of a clip except those coded at even odds.
struct NotedClip {
  int signals = 0;
  std::vector<NotedBit> bits;
};

NotedClip note_bits(QuantisedSignals coded, const std::vector<SignalNeighbours>& neighbours);

/// The coder's priors before the first bit, as floating-point numbers.
struct CodingKnowledge {
  int signals = 0;               // clips with this many signals also use priors of single signals
  std::vector<double> log_odds;  // for each context with a prior
  std::vector<int> seen;         // number of observations each prior counts for
  std::vector<double> weights;   // runtime::MixingWeights::kMost of each set

  /// The built-in priors, with which clips are coded unless a bank has learned priors.
  static CodingKnowledge of_all_clips(int signals);
};

/// The bits of the clips when coded with these priors. Uses the arithmetic of runtime::MixedBit, in
/// floats.
double coded_bits(std::span<const NotedClip> clips, const CodingKnowledge& known);

/// Counts of a context's occurrences in a clip.
struct ContextTally {
  float seen = 0;
  float set = 0;
};

/// Counts for each context of each clip: `clips` rows of `known.log_odds.size()`.
std::vector<std::vector<ContextTally>> tally_contexts(std::span<const NotedClip> clips,
                                                      const CodingKnowledge& known);

/// Fits each context by itself: log odds, searched in steps larger than `finest`, and the number of
/// observations that they count for, chosen from `trusts`. Contexts that hardly occur keep their
/// priors.
void fit_contexts(std::span<const NotedClip> clips, std::span<const std::uint16_t> trusts,
                  double finest, CodingKnowledge& known);

struct DescentPlan {
  int rounds = 0;                  // passes over all clips
  std::vector<bool> may_change;    // contexts; empty: all
  bool clips_count_alike = false;  // each clip counts the same, however many bits it has
};

/// Improves the priors along the gradient of the coded bits. Before each round, `should_continue`
/// receives the bits of each clip in the round before; if it returns false, the descent ends.
void descend(std::span<const NotedClip> clips, const DescentPlan& plan,
             const std::function<bool(const std::vector<double>&)>& should_continue,
             CodingKnowledge& known);

}  // namespace mocapress
