// SPDX-License-Identifier: MIT
// Fits what the adaptive coding knows beforehand to other clips than those it is judged by, on
// their own rigs and on ones as games have them:
//   mocapress-fit-priors CORPUS/train > core/codec/format/coefficient_priors.cpp
// --scale: the weights of the expected scale instead (value_prediction.cpp), from those of today
// on. Repeated until they stay, for what is restless follows from them; the priors come after that.
// First each context by itself: its log odds, and how many observations they are worth, from how
// alike clips are. Then log odds, weights and confidences together, by the gradient of the coded
// bits. All samples count alike, for what is known beforehand matters most where there is little to
// learn from.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <numeric>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/codec/encode/clip_analysis.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/coefficient_priors.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"
#include "tests/support/game_like.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr int kEvery[] = {1, 2, 4};                           // frames: 120, 60 and 30 Hz
constexpr double kScales[] = {4, 2.4, 1.2, 0.5, 0.15, 0.04};  // cm; eps_x is about half of it

using runtime::Confidence;
using runtime::ContextLayout;
using runtime::kMostContexts;
using runtime::kTrusts;
using runtime::MixingSets;
using runtime::MixingWeights;

constexpr std::size_t kThreads = 4;  // however many cores there are: sums keep their order

/// Calls visit(i, thread) for all i below count.
template <typename Visit>
void in_parallel(std::size_t count, const Visit& visit) {
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t)
    threads.emplace_back([=, &visit] {
      for (std::size_t i = t; i < count; i += kThreads) visit(i, t);
    });
  for (std::thread& thread : threads) thread.join();
}

/// A bit, and what it was predicted from.
struct NotedBit {
  std::array<std::uint32_t, kMostContexts> contexts;
  std::array<std::int16_t, 2> opinions;
  std::int8_t set;
  std::int8_t scale;
  std::uint8_t context_count : 4;
  std::uint8_t opinion_count : 3;
  std::uint8_t bit : 1;
};

/// All bits of a clip but those that are coded evenly.
struct Sample {
  std::size_t contexts = 0;  // those of its signals among them
  std::vector<NotedBit> bits;
};

struct NotingBits {
  static constexpr bool kWrites = true;
  bool code(bool bit, runtime::Probability) { return bit; }
  void refuse() {}
  static constexpr bool failed() { return false; }
  void note(const runtime::BitSources& sources, bool bit) {
    NotedBit noted{};
    std::copy(sources.contexts.begin(), sources.contexts.end(), noted.contexts.begin());
    std::transform(sources.opinions.begin(), sources.opinions.end(), noted.opinions.begin(),
                   [](std::int32_t opinion) { return static_cast<std::int16_t>(opinion); });
    noted.set = static_cast<std::int8_t>(sources.set);
    noted.scale = static_cast<std::int8_t>(sources.scale);
    noted.context_count = static_cast<std::uint8_t>(sources.context_count) & 15;
    noted.opinion_count = static_cast<std::uint8_t>(sources.opinion_count) & 7;
    noted.bit = bit ? 1 : 0;
    sample.bits.push_back(noted);
  }
  Sample sample;
};

/// Calls visit(signals, Bits) for each sample, once its bits have gone through `Bits`.
template <typename Bits, typename Visit>
void for_each_sample(const fs::path& folder, const Visit& visit) {
  for (const fs::path& path : clips_of(folder)) {
    const Motion motion = read_motion(path).motion;
    for (const Motion& rig : {motion, test::game_like(motion)})
      for (const int every : kEvery) {
        const ClipAnalysis source(thinned(rig, every));
        const ClipAnalysis& analysis = source.in_chosen_forms();
        const ClosedLoop& loop = analysis.closed_loop(Basis::Cubic, Weighting::Surface);
        const auto neighbours = channel_neighbours(analysis.motion().skeleton);
        for (const double scale : kScales) {
          QuantisedSignals coded = loop.quantise(scale).coded;
          auto model = CoefficientModel::untaught(coded.signal_count());
          Bits bits;
          code_coefficients(bits, neighbours, *model, coded);
          visit(coded.signal_count(), std::move(bits));
        }
      }
    std::fprintf(stderr, "%s\n", path.stem().c_str());
  }
}

std::vector<Sample> samples_of(const fs::path& folder) {
  std::vector<Sample> samples;
  for_each_sample<NotingBits>(folder, [&](int signals, NotingBits bits) {
    bits.sample.contexts = static_cast<std::size_t>(ContextLayout(signals).end);
    bits.sample.bits.shrink_to_fit();
    samples.push_back(std::move(bits.sample));
  });
  return samples;
}

// ---------------------------------------------------------------- each context by itself

struct Observed {
  double seen;
  double set;
};

/// What to know of a context: log odds, and how many observations they are worth.
struct Prior {
  double log_odds = 0;
  int trust = -1;  // of kTrusts; -1: nothing is known
};

double log_beta(double a, double b) {
  return std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
}

/// The beta distribution that most likely gave the shares of set bits in all samples.
Prior most_likely(const std::vector<Observed>& samples) {
  constexpr double kFewest = 4;
  constexpr double kMost = 60;  // of a sample: its bits are alike
  double seen = 0;
  for (const Observed& observed : samples) seen += observed.seen;
  Prior best;
  if (seen < kFewest) return best;
  double highest = -std::numeric_limits<double>::infinity();
  const auto likelihood = [&](double log_odds, double trust) {
    const double share = 1 / (1 + std::exp(-log_odds));
    const double a = trust * share + 1e-3;
    const double b = trust * (1 - share) + 1e-3;
    double sum = -0.02 * log_odds * log_odds;
    for (const Observed& observed : samples) {
      const double part = std::min(1.0, kMost / observed.seen);
      sum += log_beta(a + part * observed.set, b + part * (observed.seen - observed.set));
    }
    return sum - static_cast<double>(samples.size()) * log_beta(a, b);
  };
  for (std::size_t t = 0; t < kTrusts.size(); ++t) {
    const double trust = kTrusts[t];
    const double unlikely = 0.5 * std::pow(std::log(trust / 40), 2);
    double at = 0;
    double found = 0;
    for (double width = 1; width > 0.01; width /= 8) {
      found = -std::numeric_limits<double>::infinity();
      const double middle = at;
      for (int k = -8; k <= 8; ++k) {
        const double value = likelihood(middle + k * width, trust);
        if (value > found) {
          found = value;
          at = middle + k * width;
        }
      }
    }
    if (found - unlikely <= highest) continue;
    highest = found - unlikely;
    best = {std::clamp(at, -8.0, 8.0), static_cast<int>(t)};
  }
  return best;
}

std::vector<Prior> fit_contexts(const std::vector<Sample>& samples) {
  const auto count = static_cast<std::size_t>(ContextLayout(0).shared);
  std::vector<std::vector<Observed>> observed(count);
  std::vector<Observed> tally(count);
  for (const Sample& sample : samples) {
    std::fill(tally.begin(), tally.end(), Observed{0, 0});
    for (const NotedBit& noted : sample.bits)
      for (std::size_t i = 0; i < noted.context_count; ++i) {
        if (noted.contexts[i] >= count) continue;
        tally[noted.contexts[i]].seen += 1;
        tally[noted.contexts[i]].set += noted.bit;
      }
    for (std::size_t c = 0; c < count; ++c)
      if (tally[c].seen > 0) observed[c].push_back(tally[c]);
  }
  std::vector<Prior> priors(count);
  in_parallel(count, [&](std::size_t c, std::size_t) { priors[c] = most_likely(observed[c]); });
  return priors;
}

// ---------------------------------------------------------------- all together

/// What is trained, or a gradient of it.
struct Knowledge {
  static constexpr std::size_t kSets = MixingSets::kCount;
  std::vector<double> log_odds =
      std::vector<double>(static_cast<std::size_t>(ContextLayout(0).shared));
  std::vector<double> weights = std::vector<double>(kSets * MixingWeights::kMost);
  std::vector<double> weights_by_scale =
      std::vector<double>(kSets * MixingSets::kScaleSteps * MixingWeights::kMost);
  std::vector<double> confidences =
      std::vector<double>(MixingSets::kKinds * kMostContexts * runtime::kSeenSteps);

  static constexpr std::size_t kParts = 4;
  std::array<std::vector<double>*, kParts> parts() {
    return {&log_odds, &weights, &weights_by_scale, &confidences};
  }
};

struct Believed {
  float one;
  float first;  // what was known of it
  float left;   // how much of that still counts
  int seen;
};

float log_odds_of(float one) {
  return std::log(one / (1 - one));
}
float share_of(float log_odds) {
  return 1 / (1 + std::exp(-log_odds));
}

/// Codes a sample with what is known and adds the gradient of the logarithm of its bits, as if what
/// is learned on the way did not depend on what is known beforehand. The same arithmetic as
/// runtime::MixedBit, in floats. Returns the bits.
double code(const Sample& sample, const std::vector<Prior>& priors, const Knowledge& known,
            Knowledge* gradient) {
  constexpr float kRate = 3.0F * 256 / (1 << 17);
  constexpr float kLeast = 1.0F / 65536;
  constexpr std::size_t kMost = MixingWeights::kMost;
  const std::size_t shared = priors.size();
  std::vector<Believed> contexts(sample.contexts, {0.5F, 0.5F, 1, 0});
  for (std::size_t c = 0; c < shared; ++c) {
    const float one = share_of(static_cast<float>(known.log_odds[c]));
    const int trust = priors[c].trust < 0 ? 0 : kTrusts[static_cast<std::size_t>(priors[c].trust)];
    contexts[c] = {one, one, 1, trust};
  }
  const ContextLayout layout(0);
  // As CoefficientModel::begin_untaught() has it: zeros of single signals are likely.
  const std::size_t signals =
      (sample.contexts - shared) / static_cast<std::size_t>(ContextLayout(1).end - layout.end);
  for (std::size_t c = shared; c < shared + signals * runtime::kLevels; ++c)
    contexts[c] = {6000 / 65536.0F, 6000 / 65536.0F, 1, 1};
  std::vector<float> weights(known.weights.begin(), known.weights.end());
  std::vector<float> weights_by_scale(known.weights_by_scale.begin(), known.weights_by_scale.end());
  const auto share = static_cast<float>(1.0 / static_cast<double>(sample.bits.size()));
  double bits = 0;
  for (const NotedBit& noted : sample.bits) {
    const std::size_t count = noted.context_count;
    if (noted.set < 0) {
      Believed& context = contexts[noted.contexts[0]];
      bits -= std::log2(noted.bit != 0 ? context.one : 1 - context.one);
      context.one += (static_cast<float>(noted.bit) - context.one) * 2 /
                     static_cast<float>(2 * context.seen + 3);
      context.one = std::clamp(context.one, 64 * kLeast, 1 - 64 * kLeast);
      context.seen = std::min<int>(context.seen + 1, runtime::AdaptiveBit::kSlowest);
      continue;
    }
    const auto set = static_cast<std::size_t>(noted.set);
    const std::size_t first = set * kMost;
    const std::size_t first_of_scale =
        noted.scale < 0
            ? 0
            : (set * MixingSets::kScaleSteps + static_cast<std::size_t>(noted.scale)) * kMost;
    const std::size_t all = count + noted.opinion_count;
    std::array<float, kMost> evidence{};
    std::array<float, kMost> plain{};
    std::array<float, kMost> weight{};
    std::array<std::size_t, kMost> confidence{};
    float log_odds = 0;
    for (std::size_t i = 0; i < all; ++i) {
      if (i < count) {
        const Believed& context = contexts[noted.contexts[i]];
        confidence[i] =
            (static_cast<std::size_t>(MixingSets::kind_of(noted.set)) * kMostContexts + i) *
                runtime::kSeenSteps +
            runtime::kSeenStep[static_cast<std::size_t>(context.seen)];
        plain[i] = std::clamp(log_odds_of(context.one), -8.0F, 8.0F);
        evidence[i] = plain[i] * static_cast<float>(known.confidences[confidence[i]]);
      } else {
        evidence[i] = static_cast<float>(noted.opinions[i - count]) / 256;
      }
      weight[i] = weights[first + i] + (noted.scale < 0 ? 0 : weights_by_scale[first_of_scale + i]);
      log_odds += weight[i] * evidence[i];
    }
    const float one =
        std::clamp(share_of(std::clamp(log_odds, -8.0F, 8.0F)), 22 * kLeast, 1 - 22 * kLeast);
    bits -= std::log2(noted.bit != 0 ? one : 1 - one);
    const float surprise = static_cast<float>(noted.bit) - one;
    if (gradient != nullptr) {
      const float slope = -surprise * share;
      for (std::size_t i = 0; i < all; ++i) {
        gradient->weights[first + i] += slope * evidence[i];
        if (noted.scale >= 0) gradient->weights_by_scale[first_of_scale + i] += slope * evidence[i];
      }
      for (std::size_t i = 0; i < count; ++i) {
        gradient->confidences[confidence[i]] += slope * weight[i] * plain[i];
        const Believed& context = contexts[noted.contexts[i]];
        if (noted.contexts[i] >= shared || context.left < 1e-3F) continue;
        gradient->log_odds[noted.contexts[i]] +=
            slope * weight[i] * static_cast<float>(known.confidences[confidence[i]]) *
            context.left * context.first * (1 - context.first) / (context.one * (1 - context.one));
      }
    }
    for (std::size_t i = 0; i < all; ++i) {
      const float change = kRate * surprise * evidence[i];
      weights[first + i] += change;
      if (noted.scale >= 0) weights_by_scale[first_of_scale + i] += change;
    }
    for (std::size_t i = 0; i < count; ++i) {
      Believed& context = contexts[noted.contexts[i]];
      const float rate = 2 / static_cast<float>(2 * context.seen + 3);
      context.one = std::clamp(context.one + (static_cast<float>(noted.bit) - context.one) * rate,
                               kLeast, 1 - kLeast);
      context.left *= 1 - rate;
      context.seen = std::min<int>(context.seen + 1, runtime::AdaptiveBit::kSlowest);
    }
  }
  return bits;
}

/// Steps in the direction of the gradient, each number by what its own has been: D. Kingma and
/// J. Ba, "Adam: A Method for Stochastic Optimization", 2015.
Knowledge train(const std::vector<Sample>& samples, const std::vector<Prior>& priors) {
  constexpr int kRounds = 8;
  constexpr std::size_t kBatch = 64;
  constexpr double kFirstStep = 0.01;
  constexpr double kStepOfLogOdds = 3;  // times that
  Knowledge known;
  for (std::size_t c = 0; c < priors.size(); ++c) known.log_odds[c] = priors[c].log_odds;
  std::fill(known.weights.begin(), known.weights.end(), 0.3);
  std::fill(known.confidences.begin(), known.confidences.end(), 1);
  Knowledge mean;
  Knowledge square;
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  Random random(1);
  const std::size_t batches = (samples.size() + kBatch - 1) / kBatch;
  int step = 0;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = order.size(); i > 1; --i)
      std::swap(order[i - 1], order[static_cast<std::size_t>(random.below(i))]);
    std::vector<double> bits(samples.size());
    for (std::size_t batch = 0; batch < batches; ++batch) {
      const std::size_t first = batch * kBatch;
      const std::size_t count = std::min(kBatch, samples.size() - first);
      std::array<Knowledge, kThreads> gradients;
      in_parallel(count, [&](std::size_t i, std::size_t thread) {
        const std::size_t at = order[first + i];
        bits[at] = code(samples[at], priors, known, &gradients[thread]);
      });
      ++step;
      const double rate = kFirstStep * (1 - 0.9 * step / (kRounds * static_cast<double>(batches)));
      for (std::size_t part = 0; part < Knowledge::kParts; ++part) {
        std::vector<double>& of_part = *known.parts()[part];
        std::vector<double>& means = *mean.parts()[part];
        std::vector<double>& squares = *square.parts()[part];
        for (std::size_t i = 0; i < of_part.size(); ++i) {
          double slope = 0;
          for (Knowledge& gradient : gradients) slope += (*gradient.parts()[part])[i];
          slope /= static_cast<double>(count);
          means[i] += 0.1 * (slope - means[i]);
          squares[i] += 0.01 * (slope * slope - squares[i]);
          const double down = means[i] / (1 - std::pow(0.9, step));
          const double size = std::sqrt(squares[i] / (1 - std::pow(0.99, step)));
          of_part[i] -= (part == 0 ? kStepOfLogOdds : 1) * rate * down / (size + 1e-6);
        }
      }
      for (double& log_odds : known.log_odds) log_odds = std::clamp(log_odds, -8.0, 8.0);
    }
    double sum = 0;
    for (const double of_sample : bits) sum += std::log2(of_sample);
    std::fprintf(stderr, "%.1f bits\n", std::exp2(sum / static_cast<double>(samples.size())));
  }
  return known;
}

// ---------------------------------------------------------------- the expected scale

/// A value of a sample, in steps.
struct NotedValue {
  std::array<float, runtime::kScaleFeatures> features;
  float unrest;  // octaves
  float mean;
  float value;
  int level;
};

struct NotingValues {
  static constexpr bool kWrites = true;
  bool code(bool bit, runtime::Probability) { return bit; }
  void refuse() {}
  static constexpr bool failed() { return false; }
  void note(const runtime::ValueSources& sources) {
    NotedValue noted{};
    for (std::size_t f = 0; f < noted.features.size(); ++f)
      noted.features[f] = static_cast<float>(sources.features[f]) / 64;
    noted.unrest = static_cast<float>(sources.unrest) / 256;
    noted.mean = static_cast<float>(sources.mean) / 64;
    noted.value = static_cast<float>(sources.value);
    noted.level = sources.level;
    values.push_back(noted);
  }
  std::vector<NotedValue> values;
};

/// Every third sample: they are alike, and their values many.
std::vector<std::vector<NotedValue>> values_of(const fs::path& folder) {
  std::vector<std::vector<NotedValue>> samples;
  int at = 0;
  for_each_sample<NotingValues>(folder, [&](int, NotingValues bits) {
    if (at++ % 3 == 0 && !bits.values.empty()) samples.push_back(std::move(bits.values));
  });
  return samples;
}

using ScaleWeights = std::array<std::array<double, runtime::kScaleFeatures>, runtime::kScaleLevels>;

/// How unlikely the values are, as the logistic distribution has it whose scale follows from the
/// weights, and the gradient of that by the logarithms of the weights.
double unlikelihood(const std::vector<NotedValue>& values, const ScaleWeights& weights,
                    ScaleWeights& gradient) {
  const double share = 1.0 / std::max<double>(static_cast<double>(values.size()), 50);
  double sum = 0;
  for (const NotedValue& noted : values) {
    const auto& of_level = weights[static_cast<std::size_t>(noted.level)];
    double expected = 6.0 / 64;
    for (std::size_t f = 0; f < of_level.size(); ++f) expected += of_level[f] * noted.features[f];
    const double unrest = std::exp2(noted.unrest);
    const double width = 0.72 * (0.1 + unrest * expected);
    const auto below = [&](double x) { return 1 / (1 + std::exp(-x)); };
    const double from = (noted.value - 0.5 - noted.mean) / width;
    const double to = (noted.value + 0.5 - noted.mean) / width;
    const double likely = std::max(below(to) - below(from), 1e-9);
    sum -= share * std::log(likely);
    const double by_width =
        (from * below(from) * below(-from) - to * below(to) * below(-to)) / (width * likely);
    for (std::size_t f = 0; f < of_level.size(); ++f)
      gradient[static_cast<std::size_t>(noted.level)][f] -=
          share * by_width * 0.72 * unrest * noted.features[f] * of_level[f];
  }
  return sum;
}

/// Adam, as above, of the logarithms of the weights.
ScaleWeights fit_scale(const std::vector<std::vector<NotedValue>>& samples) {
  constexpr int kRounds = 40;
  constexpr std::size_t kBatch = 12;
  ScaleWeights weights;
  for (std::size_t level = 0; level < weights.size(); ++level)
    for (std::size_t f = 0; f < weights[level].size(); ++f)
      weights[level][f] = std::max(runtime::kScaleWeights[level][f] / 1024.0, 5e-4);
  ScaleWeights mean{};
  ScaleWeights square{};
  int step = 0;
  for (int round = 0; round < kRounds; ++round) {
    double sum = 0;
    for (std::size_t first = 0; first < samples.size(); first += kBatch) {
      ScaleWeights gradient{};
      for (std::size_t i = first; i < std::min(first + kBatch, samples.size()); ++i)
        sum += unlikelihood(samples[i], weights, gradient);
      ++step;
      const double rate = 0.03 * (1 - round / (kRounds + 1.0));
      for (std::size_t level = 0; level < weights.size(); ++level)
        for (std::size_t f = 0; f < weights[level].size(); ++f) {
          const double slope = gradient[level][f];
          mean[level][f] += 0.1 * (slope - mean[level][f]);
          square[level][f] += 0.02 * (slope * slope - square[level][f]);
          const double down = mean[level][f] / (1 - std::pow(0.9, step));
          const double size = std::sqrt(square[level][f] / (1 - std::pow(0.98, step)));
          weights[level][f] =
              std::clamp(weights[level][f] * std::exp(-rate * down / (size + 1e-7)), 2e-4, 30.0);
        }
    }
    std::fprintf(stderr, "%.5f\n", sum / static_cast<double>(samples.size()));
  }
  return weights;
}

void print_scale(const ScaleWeights& weights) {
  for (const auto& of_level : weights) {
    const char* between = "{";
    for (const double weight : of_level) {
      std::printf("%s%ld", between, std::lround(1024 * weight));
      between = ", ";
    }
    std::printf("},\n");
  }
}

// ---------------------------------------------------------------- C++

/// As C++ has to be told what is no trigraph.
std::string without_trigraphs(std::string letters) {
  for (std::size_t at = 0; (at = letters.find("??", at)) != std::string::npos; at += 2)
    letters.insert(at + 1, "\\");
  return letters;
}

void print_letters(const char* name, const std::string& letters) {
  constexpr std::size_t kLine = 90;
  std::printf("constexpr std::string_view %s =\n", name);
  for (std::size_t i = 0; i < letters.size(); i += kLine)
    std::printf("    \"%s\"%s\n", without_trigraphs(letters.substr(i, kLine)).c_str(),
                i + kLine < letters.size() ? "" : ";\n");
}

/// Numbers in 1 / `whole`, so many in a row.
void print_numbers(const std::vector<double>& numbers, double whole, std::size_t in_a_row) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    std::printf("%s%ld,", i % in_a_row == 0 ? "\n    " : " ",
                std::clamp(std::lround(whole * numbers[i]), -32768L, 32767L));
}

/// In 256ths, a row a context, in the braces of arrays within arrays.
void print_confidences(const std::vector<double>& confidences) {
  constexpr std::size_t kRow = runtime::kSeenSteps;
  constexpr std::size_t kKind = kMostContexts * kRow;
  for (std::size_t i = 0; i < confidences.size(); ++i)
    std::printf("%s%ld%s",
                i % kKind == 0  ? "\n    {{{"
                : i % kRow == 0 ? "\n      {"
                                : " ",
                std::lround(256 * confidences[i]),
                (i + 1) % kKind == 0  ? "}}},"
                : (i + 1) % kRow == 0 ? "},"
                                      : ",");
}

void print(const std::vector<Prior>& priors, const Knowledge& known) {
  std::string log_odds;
  std::string trust;
  for (std::size_t c = 0; c < priors.size(); ++c) {
    const auto steps = std::clamp(std::lround(5.5 * known.log_odds[c]), -44L, 44L);
    const bool unknown = priors[c].trust < 0;
    log_odds += unknown ? ' ' : runtime::letter_of_prior(static_cast<int>(steps));
    trust += unknown ? ' ' : static_cast<char>('a' + priors[c].trust);
  }
  constexpr std::size_t kMost = MixingWeights::kMost;
  constexpr std::size_t kOfSet = MixingSets::kScaleSteps * kMost;
  std::vector<double> weights_by_scale;
  for (std::size_t set = 0; set < Knowledge::kSets; ++set)
    if (MixingSets::has_scales(static_cast<int>(set)))
      for (std::size_t i = 0; i < kOfSet; ++i)
        weights_by_scale.push_back(known.weights_by_scale[set * kOfSet + i]);
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by tests/bench/fit_priors.cpp.\n"
      "#include \"core/codec/format/coefficient_priors.h\"\n\n#include <array>\n\n"
      "namespace mocapress::runtime {\nnamespace {\n\n// clang-format off\n");
  print_letters("kContexts", log_odds);
  print_letters("kTrust", trust);
  std::printf("constexpr std::array<std::int16_t, %zu> kWeights = {", known.weights.size());
  print_numbers(known.weights, 1024, kMost);
  std::printf("\n};\n\nconstexpr std::array<std::int16_t, %zu> kWeightsByScale = {",
              weights_by_scale.size());
  print_numbers(weights_by_scale, 1024, kMost);
  std::printf("\n};\n\nconstexpr Confidences kConfidences = {{");
  print_confidences(known.confidences);
  std::printf(
      "\n}};\n// clang-format on\n\n}  // namespace\n\n"
      "std::string_view context_priors() {\n  return kContexts;\n}\n\n"
      "std::string_view context_trust() {\n  return kTrust;\n}\n\n"
      "std::span<const std::int16_t> weight_priors() {\n  return kWeights;\n}\n\n"
      "std::span<const std::int16_t> weight_priors_by_scale() {\n  return kWeightsByScale;\n}\n\n"
      "const Confidences& confidences() {\n  return kConfidences;\n}\n\n"
      "}  // namespace mocapress::runtime\n");
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  const bool scale = argc == 3 && std::string(argv[1]) == "--scale";
  if (argc != 2 && !scale) {
    std::fprintf(stderr, "Usage: mocapress-fit-priors [--scale] CORPUS/train\n");
    return 2;
  }
  try {
    if (scale) {
      mocapress::print_scale(mocapress::fit_scale(mocapress::values_of(argv[2])));
      return 0;
    }
    const auto samples = mocapress::samples_of(argv[1]);
    const auto priors = mocapress::fit_contexts(samples);
    mocapress::print(priors, mocapress::train(samples, priors));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-fit-priors: %s\n", error.what());
    return 1;
  }
}
