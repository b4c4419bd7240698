// SPDX-License-Identifier: MIT
// Fits the initial state of the adaptive coding to the samples of training_samples.h.
//   mocapress-fit-priors CORPUS/train > core/runtime/format/coefficient_priors.cpp
// --scale fits the weights of the expected scale instead (value_prediction.cpp). Repeat it until
// they no longer change, since the samples' activity follows from them; fit the priors afterwards.
// All samples have equal weight, since priors matter most where there is little to learn from.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "core/codec/format/prior_fit.h"
#include "core/runtime/format/coefficient_priors.h"
#include "tests/bench/fit_scale.h"
#include "tests/bench/training_samples.h"

namespace mocapress {
namespace {

using runtime::kTrusts;
using runtime::MixingWeights;

CodingKnowledge fit(const std::filesystem::path& folder) {
  constexpr double kFinest = 0.01;
  std::vector<NotedClip> samples;
  for_each_sample(folder,
                  [&](QuantisedSignals coded, const std::vector<SignalNeighbours>& neighbours) {
                    samples.push_back(note_bits(std::move(coded), neighbours));
                  });
  CodingKnowledge known = CodingKnowledge::of_all_clips(0);
  std::ranges::fill(known.log_odds, 0);
  std::ranges::fill(known.seen, 0);
  std::ranges::fill(known.weights, 0.3);
  fit_contexts(samples, kTrusts, kFinest, known);
  const auto say = [](const std::vector<double>& bits) {
    double sum = 0;
    for (const double of_sample : bits) sum += std::log2(of_sample);
    const double mean = std::exp2(sum / static_cast<double>(bits.size()));
    if (mean > 0) std::fprintf(stderr, "%.1f bits\n", mean);  // known from the second round on
    return true;
  };
  descend(samples, {.rounds = 8, .clips_count_alike = true}, say, known);
  return known;
}

/// Splits a string literal where it would form a trigraph.
std::string without_trigraphs(std::string letters) {
  for (std::size_t at = 0; (at = letters.find("??", at)) != std::string::npos; at += 2)
    letters.insert(at + 1, 1, '\\');
  return letters;
}

void print_letters(const char* name, const std::string& letters) {
  constexpr std::size_t kLine = 90;
  std::printf("constexpr std::string_view %s =\n", name);
  for (std::size_t i = 0; i < letters.size(); i += kLine)
    std::printf("    \"%s\"%s\n", without_trigraphs(letters.substr(i, kLine)).c_str(),
                i + kLine < letters.size() ? "" : ";\n");
}

/// Prints numbers in units of 1 / `whole`, `per_row` in a row.
void print_numbers(const std::vector<double>& numbers, double whole, std::size_t in_a_row) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    std::printf("%s%ld,", i % in_a_row == 0 ? "\n    " : " ",
                std::clamp(std::lround(whole * numbers[i]), -32768L, 32767L));
}

void print(const CodingKnowledge& known) {
  std::string log_odds;
  std::string trust;
  for (std::size_t c = 0; c < known.log_odds.size(); ++c) {
    const auto steps = std::clamp(std::lround(5.5 * known.log_odds[c]), -44L, 44L);
    const auto trust_of = std::ranges::find(kTrusts, known.seen[c]);
    const bool unknown = trust_of == kTrusts.end();
    log_odds += unknown ? ' ' : runtime::letter_of_prior(static_cast<int>(steps));
    trust += unknown ? ' ' : static_cast<char>('a' + (trust_of - kTrusts.begin()));
  }
  constexpr std::size_t kMost = MixingWeights::kMost;
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by tests/bench/fit_priors.cpp.\n"
      "#include \"core/runtime/format/coefficient_priors.h\"\n\n#include <array>\n\n"
      "namespace mocapress::runtime {\nnamespace {\n\n// clang-format off\n");
  print_letters("kContexts", log_odds);
  print_letters("kTrust", trust);
  std::printf("constexpr std::array<std::int16_t, %zu> kWeights = {", known.weights.size());
  print_numbers(known.weights, 1024, kMost);
  std::printf(
      "\n};\n// clang-format on\n\n}  // namespace\n\n"
      "std::string_view context_priors() {\n  return kContexts;\n}\n\n"
      "std::string_view context_trust() {\n  return kTrust;\n}\n\n"
      "std::span<const std::int16_t> weight_priors() {\n  return kWeights;\n}\n\n"
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
    if (scale)
      mocapress::fit_scale_weights(argv[2]);
    else
      mocapress::print(mocapress::fit(argv[1]));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-fit-priors: %s\n", error.what());
    return 1;
  }
}
