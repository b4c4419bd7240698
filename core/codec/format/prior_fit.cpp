// SPDX-License-Identifier: MIT
#include "core/codec/format/prior_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/runtime/format/coefficient_priors.h"

namespace mocapress {
namespace {

using runtime::ContextLayout;
using runtime::MixingWeights;

constexpr std::size_t kShares =
    4;  // shares of the work on any number of cores, so that sums keep their order
constexpr std::size_t kWeightsOfSet = MixingWeights::kMost;

/// Calls visit(i, share) for all i below count, the items of one share one after the other.
template <typename Visit>
void in_shares(std::size_t count, const Visit& visit) {
  parallel_for(std::size_t{0}, kShares, [&](std::size_t share) {
    for (std::size_t i = share; i < count; i += kShares) visit(i, share);
  });
}

struct NotingBits {
  static constexpr bool kWrites = true;
  static bool code(bool bit, runtime::Probability) { return bit; }
  void refuse() {}
  static constexpr bool failed() { return false; }
  void note(const runtime::BitSources& sources, bool bit) {
    NotedBit noted{};
    std::ranges::copy(sources.contexts, noted.contexts.begin());
    std::ranges::transform(sources.opinions, noted.opinions.begin(),
                           [](std::int32_t opinion) { return static_cast<std::int16_t>(opinion); });
    noted.set = static_cast<std::int8_t>(sources.set);
    noted.context_count = static_cast<std::uint8_t>(sources.context_count) & 15;
    noted.opinion_count = static_cast<std::uint8_t>(sources.opinion_count) & 7;
    noted.bit = bit ? 1 : 0;
    bits.push_back(noted);
  }
  std::vector<NotedBit> bits;
};

/// The number of a clip's contexts that `known` covers. Contexts of single signals are among them
/// only if `known` is for clips with as many signals.
std::size_t known_contexts(const NotedClip& clip, const CodingKnowledge& known) {
  return clip.signals == known.signals ? known.log_odds.size()
                                       : static_cast<std::size_t>(ContextLayout(0).shared);
}

// Fits each context by itself.

/// On POSIX, std::lgamma also writes the sign into a global variable, which threads share.
double log_gamma(double x) {
#ifdef _WIN32
  return std::lgamma(x);
#else
  int sign = 0;
  return ::lgamma_r(x, &sign);
#endif
}

double log_beta(double a, double b) {
  return log_gamma(a) + log_gamma(b) - log_gamma(a + b);
}

struct ContextPrior {
  double log_odds = 0;
  int seen = 0;
};

/// The beta distribution that most likely produced the shares of set bits in all clips.
ContextPrior most_likely(const std::vector<ContextTally>& tallies,
                         std::span<const std::uint16_t> trusts, double finest) {
  constexpr double kMostSeen =
      60;  // most observations that one clip counts for, because its bits are alike
  ContextPrior best;
  double highest = -std::numeric_limits<double>::infinity();
  const auto likelihood = [&](double log_odds, double trust) {
    const double share = 1 / (1 + std::exp(-log_odds));
    const double a = trust * share + 1e-3;
    const double b = trust * (1 - share) + 1e-3;
    double sum = -0.02 * log_odds * log_odds;
    for (const ContextTally& tally : tallies) {
      const double seen = tally.seen;
      const double set = tally.set;
      const double part = std::min(1.0, kMostSeen / seen);
      sum += log_beta(a + part * set, b + part * (seen - set));
    }
    return sum - static_cast<double>(tallies.size()) * log_beta(a, b);
  };
  for (const int trust : trusts) {
    const double unlikely = 0.5 * std::pow(std::log(trust / 40.0), 2);
    double at = 0;
    double found = 0;
    for (double width = 1; width > finest; width /= 8) {
      found = -std::numeric_limits<double>::infinity();
      const double middle = at;
      for (int k = -8; k <= 8; ++k) {
        const double value = likelihood(middle + k * width, trust);
        if (value <= found) continue;
        found = value;
        at = middle + k * width;
      }
    }
    if (found - unlikely <= highest) continue;
    highest = found - unlikely;
    best = {std::clamp(at, -8.0, 8.0), trust};
  }
  return best;
}

// Fits all contexts together.

struct Gradient {
  explicit Gradient(const CodingKnowledge& known)
      : log_odds(known.log_odds.size()), weights(known.weights.size()) {}
  std::vector<double> log_odds;
  std::vector<double> weights;
};

constexpr std::size_t kParts = 2;
template <typename Known>
auto parts_of(Known& known) {
  return std::array{&known.log_odds, &known.weights};
}

struct Believed {
  float one = 0.5F;
  float first = 0.5F;  // the initial value of `one`
  float left = 1;      // the weight that the prior still has
  int seen = 0;
};

float log_odds_of(float one) {
  return std::log(one / (1 - one));
}
float share_of(float log_odds) {
  return 1 / (1 + std::exp(-log_odds));
}

/// Codes a clip and adds the gradient of its bits, treating the adaptation during coding as
/// independent of the priors. Each bit counts `share`. Returns the bits.
double code(const NotedClip& clip, const CodingKnowledge& known, float share, Gradient* gradient) {
  constexpr float kMixingRate = 3.0F * 256 / (1 << 18);
  constexpr float kLeast = 1.0F / 65536;
  constexpr float kSeldom = 6000.0F / 65536;
  const ContextLayout layout(clip.signals);
  const std::size_t told = known_contexts(clip, known);
  std::vector<Believed> contexts(layout.end);
  for (int c = layout.zero_own.first; c < layout.class_own.first; ++c)
    contexts[c] = {kSeldom, kSeldom, 1, 1};
  for (std::size_t c = 0; c < told; ++c) {
    const float one = share_of(static_cast<float>(known.log_odds[c]));
    contexts[c] = {one, one, 1, known.seen[c]};
  }
  std::vector<float> weights(known.weights.begin(), known.weights.end());
  const auto follow = [](Believed& context, float bit, float least) {
    const float rate = 2 / static_cast<float>(2 * context.seen + 3);
    context.one = std::clamp(context.one + (bit - context.one) * rate, least, 1 - least);
    context.left *= 1 - rate;
    context.seen = std::min<int>(context.seen + 1, runtime::AdaptiveBit::kSlowest);
  };
  double bits = 0;
  for (const NotedBit& noted : clip.bits) {
    const auto bit = static_cast<float>(noted.bit);
    const std::size_t count = noted.context_count;
    if (noted.set < 0) {
      Believed& context = contexts[noted.contexts[0]];
      bits -= std::log2(noted.bit != 0 ? context.one : 1 - context.one);
      follow(context, bit, 64 * kLeast);
      continue;
    }
    const auto set = static_cast<std::size_t>(noted.set);
    const std::size_t first = set * kWeightsOfSet;
    const std::size_t all = count + noted.opinion_count;
    std::array<float, kWeightsOfSet> evidence{};
    float log_odds = 0;
    for (std::size_t i = 0; i < all; ++i) {
      evidence[i] = i < count
                        ? std::clamp(log_odds_of(contexts[noted.contexts[i]].one), -8.0F, 8.0F)
                        : static_cast<float>(noted.opinions[i - count]) / 256;
      log_odds += weights[first + i] * evidence[i];
    }
    const float one =
        std::clamp(share_of(std::clamp(log_odds, -8.0F, 8.0F)), 22 * kLeast, 1 - 22 * kLeast);
    bits -= std::log2(noted.bit != 0 ? one : 1 - one);
    const float surprise = bit - one;
    if (gradient != nullptr) {
      const float slope = -surprise * share;
      for (std::size_t i = 0; i < all; ++i) gradient->weights[first + i] += slope * evidence[i];
      for (std::size_t i = 0; i < count; ++i) {
        const Believed& context = contexts[noted.contexts[i]];
        if (noted.contexts[i] >= told || context.left < 1e-3F) continue;
        gradient->log_odds[noted.contexts[i]] += slope * weights[first + i] * context.left *
                                                 context.first * (1 - context.first) /
                                                 (context.one * (1 - context.one));
      }
    }
    for (std::size_t i = 0; i < all; ++i)
      weights[first + i] += kMixingRate * surprise * evidence[i];
    for (std::size_t i = 0; i < count; ++i) follow(contexts[noted.contexts[i]], bit, kLeast);
  }
  return bits;
}

/// Gradient descent by D. Kingma and J. Ba, "Adam: A Method for Stochastic Optimization", 2015:
/// each parameter's step is scaled by its own past gradients.
class Descent {
 public:
  Descent(const CodingKnowledge& known, const DescentPlan& plan)
      : plan_(plan), means_(known), squares_(known) {}

  /// Takes a step by the sum of the gradients of `count` clips.
  void step(Gradient& gradient, std::size_t count, double rate, CodingKnowledge& known) {
    constexpr double kStepOfLogOdds = 3;  // times the step of the other parameters
    for (std::size_t c = 0; c < plan_.may_change.size(); ++c)
      if (!plan_.may_change[c]) gradient.log_odds[c] = 0;
    ++steps_;
    for (std::size_t part = 0; part < kParts; ++part) {
      std::vector<double>& of_part = *parts_of(known)[part];
      for (std::size_t i = 0; i < of_part.size(); ++i) {
        const double slope = (*parts_of(gradient)[part])[i] / static_cast<double>(count);
        double& mean = (*parts_of(means_)[part])[i];
        double& square = (*parts_of(squares_)[part])[i];
        mean += 0.1 * (slope - mean);
        square += 0.01 * (slope * slope - square);
        const double down = mean / (1 - std::pow(0.9, steps_));
        const double size = std::sqrt(square / (1 - std::pow(0.99, steps_)));
        of_part[i] -= (part == 0 ? kStepOfLogOdds : 1) * rate * down / (size + 1e-6);
      }
    }
    for (double& log_odds : known.log_odds) log_odds = std::clamp(log_odds, -8.0, 8.0);
  }

 private:
  const DescentPlan& plan_;
  Gradient means_;
  Gradient squares_;
  int steps_ = 0;
};

}  // namespace

NotedClip note_bits(QuantisedSignals coded, const std::vector<SignalNeighbours>& neighbours) {
  const auto signals = static_cast<int>(neighbours.size());
  auto model = CoefficientModel::untaught(signals);
  NotingBits bits;
  code_coefficients(bits, neighbours, *model, coded);
  bits.bits.shrink_to_fit();
  return {signals, std::move(bits.bits)};
}

CodingKnowledge CodingKnowledge::of_all_clips(int signals) {
  CoefficientModel model(signals);
  const auto count = static_cast<std::size_t>(ContextLayout(signals).end);
  CodingKnowledge known;
  known.signals = signals;
  known.log_odds.resize(count);
  known.seen.resize(count);
  for (std::size_t c = 0; c < count; ++c) {
    const runtime::AdaptiveBit& context = model->contexts[c];
    known.log_odds[c] = std::log(context.one / (65536.0 - context.one));
    known.seen[c] = context.seen;
  }
  for (const MixingWeights& set : model->weights)
    for (const std::int32_t weight : set.of) known.weights.push_back(weight / 65536.0);
  return known;
}

double coded_bits(std::span<const NotedClip> clips, const CodingKnowledge& known) {
  std::vector<double> bits(clips.size());
  in_shares(clips.size(),
            [&](std::size_t i, std::size_t) { bits[i] = code(clips[i], known, 1, nullptr); });
  return std::accumulate(bits.begin(), bits.end(), 0.0);
}

std::vector<std::vector<ContextTally>> tally_contexts(std::span<const NotedClip> clips,
                                                      const CodingKnowledge& known) {
  std::vector<std::vector<ContextTally>> tallies(clips.size());
  in_shares(clips.size(), [&](std::size_t i, std::size_t) {
    tallies[i].resize(known.log_odds.size());
    const std::size_t told = known_contexts(clips[i], known);
    for (const NotedBit& noted : clips[i].bits)
      for (std::size_t c = 0; c < noted.context_count; ++c) {
        if (noted.contexts[c] >= told) continue;
        tallies[i][noted.contexts[c]].seen += 1;
        tallies[i][noted.contexts[c]].set += noted.bit;
      }
  });
  return tallies;
}

void fit_contexts(std::span<const NotedClip> clips, std::span<const std::uint16_t> trusts,
                  double finest, CodingKnowledge& known) {
  constexpr double kFewest = 4;
  const auto of_clips = tally_contexts(clips, known);
  in_shares(known.log_odds.size(), [&](std::size_t c, std::size_t) {
    std::vector<ContextTally> tallies;
    double seen = 0;
    for (const auto& of_clip : of_clips) {
      if (of_clip[c].seen == 0) continue;
      tallies.push_back(of_clip[c]);
      seen += static_cast<double>(of_clip[c].seen);
    }
    if (seen < kFewest) return;
    const ContextPrior prior = most_likely(tallies, trusts, finest);
    known.log_odds[c] = prior.log_odds;
    known.seen[c] = prior.seen;
  });
}

void descend(std::span<const NotedClip> clips, const DescentPlan& plan,
             const std::function<bool(const std::vector<double>&)>& should_continue,
             CodingKnowledge& known) {
  constexpr std::size_t kBatch = 64;
  constexpr double kFirstStep = 0.01;
  constexpr float kUsualBits = 3000;  // bits of a typical clip
  Descent descent(known, plan);
  std::vector<std::size_t> order(clips.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(1);
  const std::size_t batches = (clips.size() + kBatch - 1) / kBatch;
  const double steps = plan.rounds * static_cast<double>(batches);
  double step = 0;
  std::vector<double> bits(clips.size());
  for (int round = 0; round < plan.rounds && should_continue(bits); ++round) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (std::size_t first = 0; first < clips.size(); first += kBatch) {
      const std::size_t count = std::min(kBatch, clips.size() - first);
      std::vector<Gradient> gradients(kShares, Gradient(known));
      in_shares(count, [&](std::size_t i, std::size_t share) {
        const NotedClip& clip = clips[order[first + i]];
        const float bits_of_clip =
            plan.clips_count_alike ? static_cast<float>(clip.bits.size()) : kUsualBits;
        bits[order[first + i]] = code(clip, known, 1 / bits_of_clip, &gradients[share]);
      });
      for (std::size_t share = 1; share < kShares; ++share)
        for (std::size_t part = 0; part < kParts; ++part) {
          std::vector<double>& sum = *parts_of(gradients[0])[part];
          std::ranges::transform(sum, *parts_of(gradients[share])[part], sum.begin(),
                                 std::plus<>());
        }
      ++step;
      descent.step(gradients[0], count, kFirstStep * (1 - 0.9 * step / steps), known);
    }
  }
}

}  // namespace mocapress
