// SPDX-License-Identifier: MIT
#include "core/bank/bank_learning.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>

#include "core/base/error.h"
#include "core/base/utf8_path.h"
#include "core/codec/format/container.h"
#include "core/codec/format/prior_fit.h"
#include "core/codec/format/varint.h"
#include "core/runtime/format/learned_priors.h"

namespace mocapress {
namespace {

/// A coding context that PRIO may change, since the clips taught something about it.
struct LearnedContext {
  std::size_t context;
  double worth;  // bits that changing it saves, roughly
};

std::uint8_t code_of(double log_odds, int seen) {
  constexpr double kStep = 2 * 66 / 256.0;
  const auto step = static_cast<int>(
      std::clamp(std::lround(log_odds / kStep + (runtime::kLearnedSteps - 1) / 2.0), 0L,
                 static_cast<long>(runtime::kLearnedSteps) - 1));
  // Contexts that hardly occur keep the trust of the built-in priors, which may lie between two
  // levels: this takes the nearest level.
  const auto trust = std::ranges::min_element(runtime::kLearnedTrusts, {},
                                              [&](int worth) { return std::abs(worth - seen); });
  return static_cast<std::uint8_t>(step + runtime::kLearnedSteps *
                                              (trust - runtime::kLearnedTrusts.begin()));
}

std::int8_t step_of_weight(double change) {
  constexpr double kSteps = 65536.0 / runtime::kLearnedWeightStep;
  return static_cast<std::int8_t>(std::clamp(std::lround(kSteps * change), -128L, 127L));
}

double share_of(double log_odds) {
  return 1 / (1 + std::exp(-log_odds));
}

/// Extra bits for each coded bit that is 1 with probability `is` but was expected with `expected`.
double divergence(double is, double expected) {
  return is * std::log2(is / expected) + (1 - is) * std::log2((1 - is) / (1 - expected));
}

std::vector<LearnedContext> learned_contexts(std::span<const NotedClip> clips,
                                             const CodingKnowledge& before,
                                             const CodingKnowledge& after) {
  constexpr float kSoon = 30;  // bits of one clip after which a context has adapted to it
  const auto tallies = tally_contexts(clips, after);
  std::vector<LearnedContext> learned;
  for (std::size_t c = 0; c < after.log_odds.size(); ++c) {
    if (after.seen[c] == before.seen[c] && after.log_odds[c] == before.log_odds[c]) continue;
    double seen = 0;
    for (const auto& of_clip : tallies)
      seen += static_cast<double>(std::min(of_clip[c].seen, kSoon));
    if (seen == 0 || after.seen[c] == 0) continue;
    const double worth = divergence(share_of(after.log_odds[c]), share_of(before.log_odds[c])) +
                         0.002 * std::abs(std::log((after.seen[c] + 1.0) / (before.seen[c] + 1.0)));
    learned.push_back({c, seen * worth});
  }
  std::ranges::stable_sort(learned, std::ranges::greater(), &LearnedContext::worth);
  return learned;
}

/// The payload of PRIO, and the priors that a reader gets from it.
struct Lesson {
  std::vector<std::byte> bytes;
  CodingKnowledge known;
};

Lesson lesson_of(const std::vector<bool>& is_told, const CodingKnowledge& before,
                 const CodingKnowledge& after) {
  Lesson lesson{{}, before};
  const auto signals = static_cast<std::uint16_t>(before.signals);
  const auto head = std::as_bytes(std::span(&signals, 1));
  lesson.bytes.assign(head.begin(), head.end());
  for (std::size_t i = 0; i < before.weights.size(); ++i) {
    const std::int8_t step = step_of_weight(after.weights[i] - before.weights[i]);
    lesson.known.weights[i] += step * (runtime::kLearnedWeightStep / 65536.0);
    lesson.bytes.push_back(static_cast<std::byte>(step));
  }
  std::size_t next = 0;
  for (std::size_t c = 0; c < is_told.size(); ++c) {
    if (!is_told[c]) continue;
    const std::uint8_t code = code_of(after.log_odds[c], after.seen[c]);
    write_varint(lesson.bytes, c - next);
    lesson.bytes.push_back(static_cast<std::byte>(code));
    next = c + 1;
    lesson.known.log_odds[c] = runtime::learned_log_odds(code) / 256.0;
    lesson.known.seen[c] = runtime::learned_trust(code);
  }
  return lesson;
}

/// Reads the bits of up to some hundreds of sources. Leaves out clips in segments and other codings
/// than the adaptive one.
std::vector<NotedClip> noted(const std::vector<BankSource>& sources, const BankSourceReader& files,
                             const std::function<bool()>& may_go_on) {
  constexpr std::size_t kMostClips = 600;
  const std::size_t count = std::min(sources.size(), kMostClips);
  std::vector<NotedClip> clips;
  for (std::size_t i = 0; i < count && may_go_on(); ++i) {
    const BankSource& source = sources[i * sources.size() / count];
    try {
      const Container container = read_any_container(files.read(source).bytes);
      const CompressedClip& clip = container.clip;
      if (container.of_comparison || clip.coding != Coding::Adaptive || clip.segments) continue;
      clips.push_back(note_bits(AdaptiveSegments(clip).next(), signal_neighbours(clip)));
    } catch (const FormatError& error) {
      throw InputError(utf8(source.file), 0, 0, error.what());
    }
  }
  return clips;
}

int most_frequent_signals(const std::vector<NotedClip>& clips) {
  std::map<int, int> counts;
  for (const NotedClip& clip : clips) ++counts[clip.signals];
  return std::ranges::max_element(counts, {}, &std::pair<const int, int>::second)->first;
}

}  // namespace

std::vector<std::byte> learn_from(const std::vector<BankSource>& sources,
                                  const BankSourceReader& files,
                                  const Observer<BankProgress>& observer) {
  constexpr int kRounds = 6;
  constexpr double kFinest = 0.1;  // log odds are first fitted in multiples of this
  constexpr int kMoreRounds = 4;
  constexpr std::size_t kCounts[] = {500, 1000, 2000, 4000};  // numbers of contexts to try
  bool is_stopped = false;
  const auto may_go_on = [&] {
    is_stopped = is_stopped || !should_continue(observer, BankProgress{0, sources.size()});
    return !is_stopped;
  };
  const std::vector<NotedClip> clips = noted(sources, files, may_go_on);
  if (clips.empty() || is_stopped) return {};
  const CodingKnowledge before = CodingKnowledge::of_all_clips(most_frequent_signals(clips));
  CodingKnowledge after = before;
  const auto round = [&](const std::vector<double>&) { return may_go_on(); };
  fit_contexts(clips, runtime::kLearnedTrusts, kFinest, after);
  descend(clips, {.rounds = kRounds}, round, after);
  const std::vector<LearnedContext> contexts = learned_contexts(clips, before, after);
  const double clips_for_each =
      static_cast<double>(sources.size()) / static_cast<double>(clips.size());
  const double bits_before = coded_bits(clips, before);
  double most_saved = 0;
  std::vector<std::byte> best;
  for (const std::size_t count : kCounts) {
    if (!may_go_on()) break;
    // Contexts that are not written keep their built-in priors, so the others are fitted again
    // beside them.
    CodingKnowledge told = before;
    std::vector<bool> is_told(before.log_odds.size());
    for (std::size_t i = 0; i < std::min(count, contexts.size()); ++i) {
      const std::size_t context = contexts[i].context;
      is_told[context] = true;
      told.log_odds[context] = after.log_odds[context];
      told.seen[context] = after.seen[context];
    }
    descend(clips, {.rounds = kMoreRounds, .may_change = is_told}, round, told);
    const Lesson lesson = lesson_of(is_told, before, told);
    const double saved = clips_for_each * (bits_before - coded_bits(clips, lesson.known)) / 8 -
                         static_cast<double>(lesson.bytes.size());
    if (saved > most_saved) {
      most_saved = saved;
      best = lesson.bytes;
    }
    if (count >= contexts.size()) break;
  }
  return is_stopped ? std::vector<std::byte>() : best;
}

}  // namespace mocapress
