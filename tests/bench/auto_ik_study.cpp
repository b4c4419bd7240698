// SPDX-License-Identifier: MIT
// Compares the split found by `--ik auto` with every fixed r_IK, in held feet and in bytes: at
// eps_x 0.5 cm with the closed loop, and at the paper's r = 30. Prints a Markdown table.
// Usage: mocapress-auto-ik-study CLIP|FOLDER... [--every N]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFixed = {64.0, 32.0, 16.0, 8.0, 4.0, 2.0, 1.0};  // r_IK

struct Summary {
  int rows = 0;
  int beaten = 0;
  double least_taken = 1;
  double logs_of_bytes = 0;  // bytes relative to clips without a correction
  double times = 0;          // time relative to a fixed r_IK
};

struct Setting {
  const char* name;
  Method method;
  Target target;
};
const std::array kSettings = {
    Setting{"eps 0.5 cm", Method::ClosedLoop, {Target::Kind::Error, 0.5}},
    Setting{"r = 30", Method::Annealed, {Target::Kind::CoefficientRatio, 30}}};

Encoding encode(const Encoder& encoder, const Setting& setting,
                std::optional<EncodeCorrection> correction) {
  return encoder.encode({.method = setting.method,
                         .weighting = Weighting::BoneEnds,
                         .target = setting.target,
                         .importance = {},
                         .correction = std::move(correction),
                         .contacts = {},
                         .segments = {},
                         .figures_only = true});
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Processor seconds of `work`.
template <typename Work>
double seconds_of(const Work& work) {
  const double start = processor_seconds();
  work();
  return processor_seconds() - start;
}

void study(const std::string& clip, const Encoder& encoder, const Setting& setting,
           Summary& summary) {
  const Encoding without = encode(encoder, setting, {});
  Encoding found;
  const double seconds =
      seconds_of([&] { found = encode(encoder, setting, EncodeCorrection{.joints = {}}); });
  const double left = found.footskate.total_cm;
  const double before = without.footskate.total_cm;
  const double taken = before > 0 ? 1 - left / before : 1;
  const std::size_t bytes = found.compressed.motion_bytes();
  std::string beaten_by;
  double seconds_of_fixed = 0;
  for (const double ratio : kFixed) {
    Encoding fixed;
    seconds_of_fixed += seconds_of(
        [&] { fixed = encode(encoder, setting, EncodeCorrection{.joints = {}, .ratio = ratio}); });
    if (fixed.compressed.motion_bytes() >= bytes || fixed.footskate.total_cm >= left) continue;
    beaten_by += (beaten_by.empty() ? "" : ", ") + std::to_string(std::lround(ratio));
  }
  const double times = seconds / (seconds_of_fixed / kFixed.size());
  std::printf("| %s | %g | %s | %.3g | %zu, %zu | %.2f, %.2f | %.1f %% | %s | %.1f |\n",
              clip.c_str(), encoder.motion().clip.sample_rate_hz, setting.name,
              found.correction->ratio, without.compressed.motion_bytes(), bytes, before, left,
              100 * taken, beaten_by.empty() ? "none" : beaten_by.c_str(), times);
  std::fflush(stdout);
  ++summary.rows;
  summary.beaten += beaten_by.empty() ? 0 : 1;
  summary.least_taken = std::min(summary.least_taken, taken);
  summary.times += times;
  summary.logs_of_bytes +=
      std::log(static_cast<double>(bytes) / static_cast<double>(without.compressed.motion_bytes()));
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  using namespace mocapress;
  int every = 1;
  std::vector<fs::path> clips;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--every" && i + 1 < argc) {
      every = std::max(std::atoi(argv[++i]), 1);
      continue;
    }
    for (fs::path& clip : clips_of(argv[i])) clips.push_back(std::move(clip));
  }
  if (clips.empty()) {
    std::fprintf(stderr, "Usage: mocapress-auto-ik-study CLIP|FOLDER... [--every N]\n");
    return 2;
  }
  std::printf(
      "| clip | Hz | target | r_IK | bytes without, with IK | footskate cm without, with | taken "
      "away | beaten by r_IK | times an encode at a fixed r_IK |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  try {
    Summary summary;
    for (const fs::path& clip : clips) {
      const Encoder encoder(thinned(read_motion(clip).motion, every));
      for (const Setting& setting : kSettings)
        study(clip.stem().string(), encoder, setting, summary);
    }
    std::printf("\n%d rows, %d beaten, at least %.1f %% taken away, %+.1f %% bytes, %.1f times\n",
                summary.rows, summary.beaten, 100 * summary.least_taken,
                100 * (std::exp(summary.logs_of_bytes / summary.rows) - 1),
                summary.times / summary.rows);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-auto-ik-study: %s\n", error.what());
    return 1;
  }
}
