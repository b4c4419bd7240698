// SPDX-License-Identifier: MIT
// What the adaptive coding should know of clips before their first bit, found from such clips:
// each context by itself first, from how alike clips are, then log odds and mixing weights
// together, by the gradient of the coded bits.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/codec/format/adaptive.h"

namespace mocapress {

/// A bit, and what it was predicted from.
struct NotedBit {
  std::array<std::uint32_t, runtime::kMostContexts> contexts;
  std::array<std::int16_t, 2> opinions;
  std::int8_t set;  // of weights; -1: one context alone
  std::uint8_t context_count : 4;
  std::uint8_t opinion_count : 3;
  std::uint8_t bit : 1;
};

/// All bits of a clip but those that are coded evenly.
struct NotedClip {
  int signals = 0;
  std::vector<NotedBit> bits;
};

NotedClip note_bits(QuantisedSignals coded, const std::vector<SignalNeighbours>& neighbours);

/// What is known before the first bit, in floats.
struct CodingKnowledge {
  int signals = 0;               // of clips whose single signals are known, too
  std::vector<double> log_odds;  // of each context that is known
  std::vector<int> seen;         // how many observations these are worth
  std::vector<double> weights;   // runtime::MixingWeights::kMost of each set

  /// What all clips are coded with.
  static CodingKnowledge of_all_clips(int signals);
};

/// The bits of the clips, coded with what is known. The arithmetic of runtime::MixedBit, in floats.
double coded_bits(std::span<const NotedClip> clips, const CodingKnowledge& known);

/// How often the contexts were seen in a clip.
struct ContextTally {
  float seen = 0;
  float set = 0;
};

/// Of each context of each clip, `clips` rows of `known.log_odds.size()`.
std::vector<std::vector<ContextTally>> tally_contexts(std::span<const NotedClip> clips,
                                                      const CodingKnowledge& known);

/// Learns each context by itself: log odds within `finest`, and how many observations they are
/// worth, from among `trusts`. Contexts that are hardly seen stay as they are.
void fit_contexts(std::span<const NotedClip> clips, std::span<const std::uint16_t> trusts,
                  double finest, CodingKnowledge& known);

struct DescentPlan {
  int rounds = 0;                  // through all clips
  std::vector<bool> may_change;    // contexts; empty: all
  bool clips_count_alike = false;  // and not their bits
};

/// Lets what is known follow the gradient of the coded bits. Before each round `go_on` is given the
/// bits of each clip in the round before; when that says no, what there is is as good as it got.
void descend(std::span<const NotedClip> clips, const DescentPlan& plan,
             const std::function<bool(const std::vector<double>&)>& go_on, CodingKnowledge& known);

}  // namespace mocapress
