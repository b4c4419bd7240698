// SPDX-License-Identifier: MIT
// Measures the size of each study clip by the closed loop at given errors, the time, and the best
// peers' sizes, as Markdown tables. Times are processor seconds of all threads together.
// Usage: mocapress-closed-loop-study CORPUS/study [best] [surface]
// With a weighting other than bone-ends, errors are in that weighting, and there are no peers.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/kept_memory.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/rate.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr std::array kErrors = {0.5, 0.26, 0.1, 0.05};  // cm

/// Ratios of the best peer in shared/design/peers.md at the first three of these errors, bone-ends:
/// ACL or meshoptimizer at their best settings, packed afterwards.
const std::map<std::string, std::array<double, 3>> kBestPeer = {
    {"09_01", {16.3, 11.4, 5.3}},  {"49_02", {34.4, 21.6, 9.5}},  {"02_01", {36.8, 24.2, 10.1}},
    {"02_05", {53.5, 41.3, 15.1}}, {"05_10", {17.7, 11.4, 7.0}},  {"14_06", {55.1, 37.2, 18.9}},
    {"16_22", {29.6, 16.8, 7.4}},  {"17_10", {24.8, 14.7, 6.4}},  {"29_04", {62.7, 49.7, 24.5}},
    {"49_06", {29.4, 15.5, 6.2}},  {"127_08", {15.1, 12.3, 7.0}}, {"135_07", {33.8, 24.3, 12.3}}};

/// "Optimised" in the paper's Table 1: eps_x in cm (joint-origins) and ratio.
struct PaperRow {
  const char* clip;
  double eps_cm;
  double ratio;
};
constexpr std::array kPaper = {PaperRow{"09_01", 1.4, 48},  PaperRow{"09_01", 0.96, 38},
                               PaperRow{"09_01", 0.58, 29}, PaperRow{"09_01", 0.26, 16},
                               PaperRow{"09_01", 0.08, 7},  PaperRow{"49_02", 0.67, 51},
                               PaperRow{"49_02", 0.45, 37}, PaperRow{"49_02", 0.29, 27},
                               PaperRow{"49_02", 0.14, 15}, PaperRow{"49_02", 0.05, 6.4}};

double ratio_at(const Encoder& encoder, Weighting weighting, double eps_cm, Effort effort) {
  const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                            .coding = Coding::Adaptive,
                                            .weighting = weighting,
                                            .target = {Target::Kind::Error, eps_cm},
                                            .effort = effort});
  return compression_ratio(encoder.motion().clip, encoding.compressed.motion_bytes());
}

double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void at_each_error(const fs::path& folder, Weighting weighting, Effort effort) {
  std::vector<fs::path> clips;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".amc") clips.push_back(entry.path());
  std::sort(clips.begin(), clips.end());

  std::printf(
      "| clip | frames | ratio at 0.5, 0.26, 0.1, 0.05 cm | of the best peer's | frames/s |\n");
  std::printf("| --- | --- | --- | --- | --- |\n");
  std::array<double, kErrors.size()> logs{};
  std::array<double, kErrors.size()> seconds{};
  double least = INFINITY;
  double frames = 0;
  for (const fs::path& path : clips) {
    const std::string clip = path.stem().string();
    const Motion motion = read_motion(path).motion;
    frames += motion.clip.frames();
    std::string ratios;
    std::string factors;
    std::string speeds;
    for (std::size_t i = 0; i < kErrors.size(); ++i) {
      const double start = processor_seconds();
      const double ratio = ratio_at(Encoder(motion), weighting, kErrors[i], effort);
      const double took = processor_seconds() - start;
      seconds[i] += took;
      logs[i] += std::log(ratio);
      char text[64];
      std::snprintf(text, sizeof text, "%s%.1f", i ? ", " : "", ratio);
      ratios += text;
      std::snprintf(text, sizeof text, "%s%.0f", i ? ", " : "", motion.clip.frames() / took);
      speeds += text;
      const auto peer = kBestPeer.find(clip);
      if (weighting != Weighting::BoneEnds || peer == kBestPeer.end() || i >= peer->second.size())
        continue;
      const double factor = ratio / peer->second[i];
      least = std::min(least, factor);
      std::snprintf(text, sizeof text, "%s%.2f", i ? ", " : "", factor);
      factors += text;
    }
    std::printf("| %s | %d | %s | %s | %s |\n", clip.c_str(), motion.clip.frames(), ratios.c_str(),
                factors.c_str(), speeds.c_str());
    std::fflush(stdout);
  }
  std::printf("| all | %.0f |", frames);
  for (const double sum : logs)
    std::printf(" %.1f", std::exp(sum / static_cast<double>(clips.size())));
  if (std::isfinite(least))
    std::printf(" | at least %.2f |", least);
  else
    std::printf(" | |");
  for (const double sum : seconds) std::printf(" %.0f", frames / sum);
  std::printf(" |\n\n");
}

void against_paper(const fs::path& folder, Effort effort) {
  std::printf("| clip | eps_x cm, joint-origins | ratio | of the paper's optimised |\n");
  std::printf("| --- | --- | --- | --- |\n");
  std::map<std::string, Encoder> encoders;
  for (const PaperRow& row : kPaper) {
    if (!encoders.contains(row.clip))
      encoders.emplace(row.clip, read_motion(folder / (std::string(row.clip) + ".amc")).motion);
    const double ratio =
        ratio_at(encoders.at(row.clip), Weighting::JointOrigins, row.eps_cm, effort);
    std::printf("| %s | %g | %.1f | %.2f |\n", row.clip, row.eps_cm, ratio, ratio / row.ratio);
  }
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  mocapress::keep_freed_memory();  // as the programs do
  using mocapress::Effort;
  using mocapress::Weighting;
  auto effort = Effort::Default;
  auto weighting = Weighting::BoneEnds;
  bool is_understood = argc >= 2;
  for (int i = 2; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "best")
      effort = Effort::Best;
    else if (word == "surface")
      weighting = Weighting::Surface;
    else
      is_understood = false;
  }
  if (!is_understood) {
    std::fprintf(stderr, "Usage: mocapress-closed-loop-study CORPUS/study [best] [surface]\n");
    return 2;
  }
  try {
    mocapress::at_each_error(argv[1], weighting, effort);
    if (weighting == Weighting::BoneEnds) mocapress::against_paper(argv[1], effort);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-closed-loop-study: %s\n", error.what());
    return 1;
  }
}
