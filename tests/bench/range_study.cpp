// SPDX-License-Identifier: MIT
// Prints how much smaller the error gets in a range of frames that is more important, and what that
// costs. The range is the middle fifth of each clip.
// Usage: mocapress-range-study CLIP|FOLDER... [--error CM | --max-error CM]
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

struct Result {
  double bytes = 0;
  double inside = 0;   // cm: RMS, or the largest under a hard maximum
  double outside = 0;  // cm
};

Result compressed(const Encoder& encoder, const Target& target, const ImportantRange& range) {
  const Encoding encoding = encoder.encode({.target = target, .ranges = {range}});
  const Skeleton& skeleton = encoder.motion().skeleton;
  const PointErrors errors(skeleton, Weighting::Surface);
  const Eigen::MatrixXd squared =
      errors.squared(encoder.original_body(), body_tracks(skeleton, encoding.decoded));
  const bool by_worst = target.kind == Target::Kind::MaxError;
  const Eigen::VectorXd of_frames =
      by_worst ? squared.rowwise().maxCoeff().eval() : (squared * errors.measured().weights).eval();
  const int count = range.last_frame - range.first_frame + 1;
  const auto within = of_frames.segment(range.first_frame, count);
  const auto before = of_frames.head(range.first_frame);
  const auto after = of_frames.tail(of_frames.size() - range.last_frame - 1);
  Result result{.bytes = static_cast<double>(encoding.compressed.motion_bytes())};
  if (by_worst) {
    result.inside = std::sqrt(within.maxCoeff());
    result.outside = std::sqrt(std::max(before.maxCoeff(), after.maxCoeff()));
  } else {
    result.inside = std::sqrt(within.mean());
    result.outside =
        std::sqrt((before.sum() + after.sum()) / static_cast<double>(of_frames.size() - count));
  }
  return result;
}

void study(const std::vector<std::filesystem::path>& clips, const Target& target) {
  constexpr std::array kFactors = {2.0, 3.0, 4.0, 8.0};
  struct Sums {
    double inside = 0, outside = 0, bytes = 0, least = 1e9;
  };
  std::array<Sums, kFactors.size()> sums;
  for (const std::filesystem::path& clip : clips) {
    const Encoder encoder(read_motion(clip).motion);
    const int frames = encoder.motion().clip.frames();
    ImportantRange range{2 * frames / 5, 3 * frames / 5 - 1, 1};
    const Result plain = compressed(encoder, target, range);
    for (std::size_t i = 0; i < kFactors.size(); ++i) {
      range.factor = kFactors[i];
      const Result careful = compressed(encoder, target, range);
      sums[i].inside += std::log(plain.inside / careful.inside);
      sums[i].outside += std::log(plain.outside / careful.outside);
      sums[i].bytes += std::log(careful.bytes / plain.bytes);
      sums[i].least = std::min(sums[i].least, plain.inside / careful.inside);
      std::fprintf(stderr,
                   "%s x%g: %.0f -> %.0f bytes, inside %.4f -> %.4f, outside %.4f -> %.4f\n",
                   clip.stem().string().c_str(), range.factor, plain.bytes, careful.bytes,
                   plain.inside, careful.inside, plain.outside, careful.outside);
    }
  }
  const double count = static_cast<double>(clips.size());
  std::printf(
      "| factor | error in the range, times smaller (least) | elsewhere | bytes |\n"
      "| --- | --- | --- | --- |\n");
  for (std::size_t i = 0; i < kFactors.size(); ++i)
    std::printf("| %g | %.2f (%.2f) | %.2f | %+.1f %% |\n", kFactors[i],
                std::exp(sums[i].inside / count), sums[i].least, std::exp(sums[i].outside / count),
                100 * std::expm1(sums[i].bytes / count));
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  using namespace mocapress;
  Target target{Target::Kind::Error, 0.5};
  std::vector<std::filesystem::path> clips;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if ((word == "--error" || word == "--max-error") && i + 1 < argc) {
      target.kind = word == "--error" ? Target::Kind::Error : Target::Kind::MaxError;
      target.value = number_in(argv[++i]).value_or(target.value);
      continue;
    }
    for (std::filesystem::path& clip : clips_of(argv[i])) clips.push_back(std::move(clip));
  }
  if (clips.empty()) {
    std::fprintf(stderr,
                 "Usage: mocapress-range-study CLIP|FOLDER... [--error CM | --max-error CM]\n");
    return 2;
  }
  try {
    study(clips, target);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-range-study: %s\n", error.what());
    return 1;
  }
}
