// SPDX-License-Identifier: MIT
#include "tests/bench/fit_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "tests/bench/training_samples.h"

namespace mocapress {
namespace {

/// A value of a sample, in quantisation steps.
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

/// Uses every third sample: they are alike and have many values.
std::vector<std::vector<NotedValue>> values_of(const std::filesystem::path& folder) {
  std::vector<std::vector<NotedValue>> samples;
  int at = 0;
  for_each_sample(folder,
                  [&](QuantisedSignals coded, const std::vector<SignalNeighbours>& neighbours) {
                    if (at++ % 3 != 0) return;
                    auto model = CoefficientModel::untaught(coded.signal_count());
                    NotingValues bits;
                    code_coefficients(bits, neighbours, *model, coded);
                    if (!bits.values.empty()) samples.push_back(std::move(bits.values));
                  });
  return samples;
}

using ScaleWeights = std::array<std::array<double, runtime::kScaleFeatures>, runtime::kScaleLevels>;

/// The negative log-likelihood of the values under the logistic distribution whose scale follows
/// from the weights, and its gradient by the weights' logarithms.
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

/// D. Kingma and J. Ba, "Adam: A Method for Stochastic Optimization", 2015, applied to the
/// logarithms of the weights.
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

}  // namespace

void fit_scale_weights(const std::filesystem::path& folder) {
  print_scale(fit_scale(values_of(folder)));
}

}  // namespace mocapress
