// SPDX-License-Identifier: MIT
// How the ends of clips fare beside the rest of them, as a Markdown table: the RMS error of the
// first and last frame, and of the four at either end, as shares of the clip's own.
// Usage: mocapress-ends-study CLIP|FOLDER... [--every N] [--error CM]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "core/codec/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/rate.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

constexpr int kBeside = 4;  // frames at either end

struct Ends {
  double ratio;
  double eps_cm;
  std::array<double, 4> shares;  // first frame, last, first few, last few; of eps_cm
};

Ends measure_ends(const Motion& motion, double target_cm) {
  const Encoder encoder(motion);
  const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                            .coding = Coding::Adaptive,
                                            .weighting = Weighting::Surface,
                                            .target = {Target::Kind::Error, target_cm}});
  const PointErrors errors(motion.skeleton, Weighting::Surface);
  const Eigen::VectorXd squares =
      errors.squared(encoder.original_body(), body_tracks(motion.skeleton, encoding.decoded)) *
      errors.measured().weights;
  const Eigen::Index few = std::min<Eigen::Index>(kBeside, squares.size());
  const double mean = squares.mean();
  const auto share = [&](double square) { return std::sqrt(square / mean); };
  return {compression_ratio(motion.clip, encoding.compressed.motion_bytes()),
          std::sqrt(mean),
          {share(squares(0)), share(squares(squares.size() - 1)), share(squares.head(few).mean()),
           share(squares.tail(few).mean())}};
}

int run(const std::vector<std::string>& paths, int every, double target_cm) {
  std::printf("| clip | ratio | eps, cm | first frame | last | first 4 | last 4 |\n");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |\n");
  std::array<double, 4> sums{};
  std::array<double, 4> worst{};
  double logs = 0;
  int clips = 0;
  for (const std::string& path : paths)
    for (const auto& clip : clips_of(path)) {
      const Ends ends = measure_ends(thinned(read_motion(clip).motion, every), target_cm);
      std::printf("| %s | %.1f | %.3f |", clip.stem().c_str(), ends.ratio, ends.eps_cm);
      for (std::size_t i = 0; i < sums.size(); ++i) {
        std::printf(" %.2f |", ends.shares[i]);
        sums[i] += ends.shares[i];
        worst[i] = std::max(worst[i], ends.shares[i]);
      }
      std::printf("\n");
      logs += std::log(ends.ratio);
      ++clips;
    }
  std::printf("| mean | %.1f | |", std::exp(logs / clips));
  for (const double sum : sums) std::printf(" %.2f |", sum / clips);
  std::printf("\n| worst | | |");
  for (const double share : worst) std::printf(" %.2f |", share);
  std::printf("\n");
  return 0;
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  int every = 1;
  double target_cm = 0.5;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string_view argument = argv[i];
      if (argument == "--every" && i + 1 < argc)
        every = std::stoi(argv[++i]);
      else if (argument == "--error" && i + 1 < argc)
        target_cm = mocapress::number_in(argv[++i]).value();
      else
        paths.emplace_back(argument);
    }
    if (paths.empty() || every < 1) {
      std::fprintf(stderr, "Usage: mocapress-ends-study CLIP|FOLDER... [--every N] [--error CM]\n");
      return 2;
    }
    return mocapress::run(paths, every, target_cm);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-ends-study: %s\n", error.what());
    return 1;
  }
}
