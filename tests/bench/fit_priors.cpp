// SPDX-License-Identifier: MIT
// Fits what the adaptive coding knows beforehand to other clips than those it is judged by, on
// their own rigs and on ones as games have them:
//   mocapress-fit-priors CORPUS/train > core/codec/format/coefficient_priors.cpp
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "core/codec/encode/clip_analysis.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/coefficient_priors.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"
#include "tests/support/game_like.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr int kEvery[] = {1, 2, 4};                                 // frames: 120, 60 and 30 Hz
constexpr double kScales[] = {4, 2.4, 1.2, 0.5, 0.15, 0.04, 0.01};  // cm; eps_x is about half of it

struct Sample {
  std::vector<SignalNeighbours> kin;
  QuantisedSignals coded;
};

using runtime::ContextLayout;
using runtime::letter_of_prior;
using runtime::MixingWeights;
using ContextTally = std::vector<runtime::ContextCount>;

struct IgnoredBits {
  static constexpr bool kWrites = true;
  bool code(bool bit, runtime::Probability) { return bit; }
  void refuse() {}
  static constexpr bool failed() { return false; }
};

std::vector<Sample> samples_of(const fs::path& folder) {
  std::vector<Sample> samples;
  for (const fs::path& path : clips_of(folder)) {
    const Motion motion = read_motion(path).motion;
    for (const Motion& rig : {motion, test::game_like(motion)})
      for (const int every : kEvery) {
        const ClipAnalysis source(thinned(rig, every));
        const ClipAnalysis& analysis = source.in_chosen_forms();
        const ClosedLoop& loop = analysis.closed_loop(Basis::Cubic, Weighting::Surface);
        for (const double scale : kScales)
          samples.push_back(
              {channel_neighbours(analysis.motion().skeleton), loop.quantise(scale).coded});
      }
    std::fprintf(stderr, "%s\n", path.stem().c_str());
  }
  return samples;
}

void code(Sample& sample, CoefficientModel& model, ContextTally* tally) {
  IgnoredBits bits;
  code_coefficients(bits, sample.kin, *model, sample.coded,
                    tally == nullptr ? nullptr : tally->data());
}

/// Letters of the shared contexts, by how often their bits were set. All samples count alike, for
/// what is known beforehand matters most where there is little to learn from.
std::string fit_contexts(std::vector<Sample>& samples) {
  constexpr std::uint32_t kFewest = 4;
  const auto count = static_cast<std::size_t>(ContextLayout(0).shared);
  std::vector<std::uint32_t> seen(count);
  std::vector<double> shares(count);  // of its sample's bits, summed over all samples
  std::vector<double> shares_set(count);
  for (Sample& sample : samples) {
    auto model = CoefficientModel::untaught(static_cast<int>(sample.kin.size()));
    ContextTally tally(count);
    code(sample, model, &tally);
    double bits = 1;
    for (const auto& [seen_here, set] : tally) bits += seen_here;
    for (std::size_t c = 0; c < count; ++c) {
      seen[c] += tally[c][0];
      shares[c] += tally[c][0] / bits;
      shares_set[c] += tally[c][1] / bits;
    }
  }
  std::string letters;
  for (std::size_t c = 0; c < count; ++c) {
    const double ones = seen[c] < kFewest ? 0 : seen[c] * shares_set[c] / shares[c];
    const double odds = (ones + 0.3) / (seen[c] - ones + 0.3);
    const auto steps = std::clamp(std::lround(5.5 * std::log(odds)), -44L, 44L);
    letters += seen[c] < kFewest ? ' ' : letter_of_prior(static_cast<int>(steps));
  }
  return letters;
}

/// The weights that the mixing comes to, in the mean over all samples, each from where the one
/// before left them.
std::vector<int> fit_weights(std::vector<Sample>& samples, const std::string& letters) {
  auto taught = CoefficientModel::untaught(0)->weights;
  std::vector<double> sums(taught.size() * MixingWeights::kMost);
  const auto rounds = [&](const auto& visit) {
    for (Sample& sample : samples) {
      auto model = CoefficientModel::untaught(static_cast<int>(sample.kin.size()));
      model->teach(letters);
      model->weights = taught;
      code(sample, model, nullptr);
      taught = model->weights;
      visit();
    }
  };
  rounds([] {});  // from the common start to what the clips have in common
  rounds([&] {
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += taught[i / MixingWeights::kMost].of[i % MixingWeights::kMost];
  });
  std::vector<int> shares;
  for (const double sum : sums)
    shares.push_back(static_cast<int>(std::lround(sum / static_cast<double>(samples.size()) / 64)));
  return shares;
}

/// As C++ has to be told what is no trigraph.
std::string without_trigraphs(std::string letters) {
  for (std::size_t at = 0; (at = letters.find("??", at)) != std::string::npos; at += 2)
    letters.insert(at + 1, "\\");
  return letters;
}

void print(const std::string& letters, const std::vector<int>& shares) {
  constexpr std::size_t kLine = 90;
  std::printf(
      "// SPDX-License-Identifier: MIT\n// Made by tests/bench/fit_priors.cpp.\n"
      "#include \"core/codec/format/coefficient_priors.h\"\n\n#include <array>\n\n"
      "namespace mocapress::runtime {\nnamespace {\n\n// clang-format off\n"
      "constexpr std::string_view kContexts =\n");
  for (std::size_t i = 0; i < letters.size(); i += kLine)
    std::printf("    \"%s\"%s\n", without_trigraphs(letters.substr(i, kLine)).c_str(),
                i + kLine < letters.size() ? "" : ";");
  std::printf("\nconstexpr std::array<std::int16_t, %zu> kWeights = {", shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    std::printf("%s%d,", i % MixingWeights::kMost == 0 ? "\n    " : " ", shares[i]);
  std::printf(
      "\n};\n// clang-format on\n\n}  // namespace\n\n"
      "std::string_view context_priors() {\n  return kContexts;\n}\n\n"
      "std::span<const std::int16_t> weight_priors() {\n  return kWeights;\n}\n\n"
      "}  // namespace mocapress::runtime\n");
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: mocapress-fit-priors CORPUS/train\n");
    return 2;
  }
  try {
    auto samples = mocapress::samples_of(argv[1]);
    const std::string letters = mocapress::fit_contexts(samples);
    mocapress::print(letters, mocapress::fit_weights(samples, letters));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-fit-priors: %s\n", error.what());
    return 1;
  }
}
