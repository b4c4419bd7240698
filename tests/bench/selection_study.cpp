// SPDX-License-Identifier: MIT
// Measures the gain of annealing at equal coded size: eps_x (joint-origins) of each selection on
// the study clips. Prints a Markdown table.
// Usage: mocapress-selection-study CORPUS/study
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr double kRatios[] = {10, 20, 40};

std::vector<fs::path> clips_in(const fs::path& folder) {
  std::vector<fs::path> clips;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".amc") clips.push_back(entry.path());
  std::sort(clips.begin(), clips.end());
  return clips;
}

double eps_cm(const Encoder& encoder, Method method, double ratio) {
  return encoder
      .encode({.method = method,
               .coding = Coding::Deflate,
               .weighting = Weighting::JointOrigins,
               .target = {Target::Kind::Ratio, ratio}})
      .distortion.eps_joint_origins;
}

/// Prints one row and returns the gain of annealing: standard / annealed.
double study(const std::string& clip, const Encoder& encoder, double ratio) {
  const double per_channel = eps_cm(encoder, Method::PerChannel, ratio);
  const double standard = eps_cm(encoder, Method::Standard, ratio);
  const double annealed = eps_cm(encoder, Method::Annealed, ratio);
  std::printf("| %s | %g | %.3f | %.3f | %.3f | %.2f |\n", clip.c_str(), ratio, per_channel,
              standard, annealed, standard / annealed);
  std::fflush(stdout);
  return standard / annealed;
}

double geometric_mean(const std::vector<double>& values) {
  double sum_of_logs = 0;
  for (const double value : values) sum_of_logs += std::log(value);
  return std::exp(sum_of_logs / static_cast<double>(values.size()));
}

void run(const fs::path& folder) {
  std::printf(
      "| clip | ratio | per-channel cm | standard cm | annealed cm | standard / annealed |\n");
  std::printf("| --- | --- | --- | --- | --- | --- |\n");
  std::vector<double> all;
  std::vector<double> gains[std::size(kRatios)];
  for (const fs::path& clip : clips_in(folder)) {
    const Encoder encoder(read_motion(clip).motion);
    for (std::size_t i = 0; i < std::size(kRatios); ++i) {
      gains[i].push_back(study(clip.stem().string(), encoder, kRatios[i]));
      all.push_back(gains[i].back());
    }
  }
  for (std::size_t i = 0; i < std::size(kRatios); ++i)
    std::printf("| geometric mean | %g | | | | %.2f |\n", kRatios[i], geometric_mean(gains[i]));
  std::printf("| geometric mean | all | | | | %.2f |\n", geometric_mean(all));
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "Usage: mocapress-selection-study CORPUS/study\n");
    return 2;
  }
  try {
    mocapress::run(argv[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-selection-study: %s\n", error.what());
    return 1;
  }
}
