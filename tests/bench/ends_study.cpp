// SPDX-License-Identifier: MIT
// Compares the errors at the ends of clips with the rest, as a Markdown table: the RMS error of the
// first and last frame, and of the four frames at each end, relative to the clip's own.
// --loops takes the most loop-like stretch of each clip, closed to a loop
// (tests/support/loop_of.h). It also prints the change in the errors of pose and velocity at the
// seam, relative to the largest change between neighbouring frames, and whether the encoder
// detected the loop.
// --game uses game-like rigs.
// Usage: mocapress-ends-study CLIP|FOLDER... [--every N] [--game] [--loops] [--error CM]
//   [--ends free|even|exact]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/rate.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/study_clips.h"
#include "tests/support/game_like.h"
#include "tests/support/loop_of.h"

namespace mocapress {
namespace {

constexpr int kBeside = 4;  // frames at either end

struct ClipEnds {
  double ratio;
  double eps_cm;
  // Errors of first frame, last frame, first few and last few, relative to eps_cm; pose and
  // velocity at the seam, relative to the worst pair of neighbours.
  std::array<double, 6> shares;
  Loop loop;
};

ClipEnds measure_ends(const Motion& motion, double target_cm, Ends ends) {
  const Encoder encoder(motion);
  const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                            .coding = Coding::Adaptive,
                                            .weighting = Weighting::Surface,
                                            .target = {Target::Kind::Error, target_cm},
                                            .ends = ends});
  const PointErrors errors(motion.skeleton, Weighting::Surface);
  const Eigen::VectorXd squares =
      errors.squared(encoder.original_body(), body_tracks(motion.skeleton, encoding.decoded)) *
      errors.measured().weights;
  const Eigen::Index few = std::min<Eigen::Index>(kBeside, squares.size());
  const double mean = squares.mean();
  const auto share = [&](double square) { return std::sqrt(square / mean); };
  const EndErrors& seams = encoding.distortion.ends;
  return {compression_ratio(motion.clip, encoding.compressed.motion_bytes()),
          std::sqrt(mean),
          {share(squares(0)), share(squares(squares.size() - 1)), share(squares.head(few).mean()),
           share(squares.tail(few).mean()), seams.seam_cm / seams.worst_neighbours_cm,
           seams.seam_cm_per_frame / seams.worst_neighbours_cm_per_frame},
          encoding.compressed.loop};
}

struct Asked {
  std::vector<std::string> paths;
  int every = 1;
  bool on_game_rig = false;
  bool loops = false;
  double target_cm = 0.5;
  Ends ends = Ends::Even;
};

int run(const Asked& asked) {
  const std::size_t columns = asked.loops ? 6 : 4;
  std::printf("| clip | ratio | eps, cm | first frame | last | first 4 | last 4 |%s\n",
              asked.loops ? " seam | its velocity | loop |" : "");
  std::printf("| --- | --- | --- | --- | --- | --- | --- |%s\n",
              asked.loops ? " --- | --- | --- |" : "");
  std::array<double, 6> sums{};
  std::array<double, 6> worst{};
  double logs = 0;
  int clips = 0;
  for (const std::string& path : asked.paths)
    for (const auto& clip : clips_of(path)) {
      Motion motion = thinned(read_motion(clip).motion, asked.every);
      if (asked.loops) motion = test::loop_of(motion);
      if (asked.on_game_rig) motion = test::game_like(motion);
      const ClipEnds ends = measure_ends(motion, asked.target_cm, asked.ends);
      std::printf("| %s | %.1f | %.3f |", clip.stem().c_str(), ends.ratio, ends.eps_cm);
      for (std::size_t i = 0; i < columns; ++i) {
        std::printf(" %.2f |", ends.shares[i]);
        sums[i] += ends.shares[i];
        worst[i] = std::max(worst[i], ends.shares[i]);
      }
      std::printf("%s\n", asked.loops ? (" " + std::string(name(ends.loop)) + " |").c_str() : "");
      logs += std::log(ends.ratio);
      ++clips;
    }
  std::printf("| mean | %.1f | |", std::exp(logs / clips));
  for (std::size_t i = 0; i < columns; ++i) std::printf(" %.2f |", sums[i] / clips);
  std::printf("\n| worst | | |");
  for (std::size_t i = 0; i < columns; ++i) std::printf(" %.2f |", worst[i]);
  std::printf("\n");
  return 0;
}

Ends ends_named(std::string_view word) {
  for (const Ends ends : {Ends::Free, Ends::Even, Ends::Exact})
    if (name(ends) == word) return ends;
  throw Error("no such --ends: " + std::string(word));
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  mocapress::Asked asked;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string_view argument = argv[i];
      if (argument == "--every" && i + 1 < argc)
        asked.every = std::stoi(argv[++i]);
      else if (argument == "--game")
        asked.on_game_rig = true;
      else if (argument == "--loops")
        asked.loops = true;
      else if (argument == "--error" && i + 1 < argc)
        asked.target_cm = mocapress::number_in(argv[++i]).value();
      else if (argument == "--ends" && i + 1 < argc)
        asked.ends = mocapress::ends_named(argv[++i]);
      else
        asked.paths.emplace_back(argument);
    }
    if (asked.paths.empty() || asked.every < 1) {
      std::fprintf(stderr,
                   "Usage: mocapress-ends-study CLIP|FOLDER... [--every N] [--game] [--loops] "
                   "[--error CM] [--ends free|even|exact]\n");
      return 2;
    }
    return mocapress::run(asked);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-ends-study: %s\n", error.what());
    return 1;
  }
}
