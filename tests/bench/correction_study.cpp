// SPDX-License-Identifier: MIT
// Measures the cost and gain of held feet at the paper's r = 30 and r_IK = 16, against the same
// annealing at the same size without them. Prints a Markdown table.
// Usage: mocapress-correction-study CLIP...
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"

namespace mocapress {
namespace {

void study(const std::filesystem::path& clip, Weighting weighting) {
  const Encoder encoder(read_motion(clip).motion);
  const Encoding with = encoder.encode({.method = Method::Annealed,
                                        .weighting = weighting,
                                        .target = {Target::Kind::CoefficientRatio, 30},
                                        .correction = EncodeCorrection{.ratio = 16.0}});
  const auto bytes = static_cast<double>(with.compressed.motion_bytes());
  const Encoding without = encoder.encode(
      {.method = Method::Annealed, .weighting = weighting, .target = {Target::Kind::Size, bytes}});
  const double eps = with.distortion.eps(weighting);
  const double eps_without = without.distortion.eps(weighting);
  const double less = 1 - with.footskate.total_cm / std::max(without.footskate.total_cm, 1e-9);
  const double knees = with.correction->fastest_knee / with.correction->fastest_knee_of_original;
  std::printf("| %s | %s | %.0f | %zu | %.3f | %.3f | %+.0f %% | %.2f | %.2f | %.0f %% | %.2f |\n",
              clip.stem().string().c_str(), name(weighting).data(), bytes, with.correction->bytes,
              eps_without, eps, 100 * (eps / eps_without - 1), without.footskate.total_cm,
              with.footskate.total_cm, 100 * less, knees);
  std::fflush(stdout);
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  using namespace mocapress;
  if (argc < 2) {
    std::fprintf(stderr, "Usage: mocapress-correction-study CLIP...\n");
    return 2;
  }
  std::printf(
      "| clip | weighting | bytes | of IK | eps_x cm without | with IK | rise | footskate cm "
      "without "
      "| with IK | less | knee speed / original |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  try {
    for (int i = 1; i < argc; ++i)
      for (const Weighting weighting : {Weighting::BoneEnds, Weighting::JointOrigins})
        study(argv[i], weighting);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-correction-study: %s\n", error.what());
    return 1;
  }
}
