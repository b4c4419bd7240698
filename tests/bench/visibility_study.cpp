// SPDX-License-Identifier: MIT
// Measures visibility of clips at several errors, as Markdown tables: RMS and maximum on the
// surface, the verdict with its reason, and each cue's worst in noticeable thresholds. Then lists
// pairs of clips that the three figures rank in different order, on request with pictures on an
// HTML page.
// Usage: mocapress-visibility-study CLIP|FOLDER... [--every N] [--page FILE]
#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/number_text.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/motion_file.h"
#include "core/metrics/rate.h"
#include "core/metrics/visibility.h"
#include "core/motion/body_tracks.h"
#include "tests/bench/disagreement_page.h"
#include "tests/bench/study_clips.h"

namespace mocapress {
namespace {

constexpr std::array<double, 4> kTargets = {0.1, 0.26, 0.5, 1};  // cm on the surface

struct Row {
  std::string clip;
  double target_cm = 0;
  double ratio = 0;
  std::array<double, 3> figures{};  // RMS, maximum (cm), noticeable thresholds
  std::array<double, kCues> times{};
  Sight sight{};
  std::string why;
  LookedAt looked_at;

  std::string name() const { return clip + " at " + significant_text(target_cm, 3) + " cm"; }
};

LookedAt look_at(const Encoder& encoder, const Distortion& distortion,
                 const Eigen::MatrixXd& decoded, const Visibility& seen) {
  const Motion& motion = encoder.motion();
  const Eigen::MatrixXd& original = encoder.original_body();
  const PointErrors surface(motion.skeleton, Weighting::Surface);
  const Eigen::MatrixXd squares = surface.squared(original, decoded);
  const Eigen::VectorXd& weights = surface.measured().weights;
  LookedAt looked{.seconds = motion.clip.frames() / motion.clip.sample_rate_hz,
                  .rms_cm = (squares * weights / weights.sum()).cwiseSqrt(),
                  .max_cm = squares.rowwise().maxCoeff().cwiseSqrt(),
                  .sights = sight_chart(seen.table, motion.skeleton)};
  const Eigen::Index on_bones = 3 * std::ssize(landmarks(motion.skeleton));
  const double ground_cm = ground_of(encoder.original_tracks());
  const auto pose = [&](const WorstPoint& point) {
    return worst_pose(motion.skeleton, points_at(original.leftCols(on_bones), point.frame),
                      points_at(decoded.leftCols(on_bones), point.frame), ground_cm, point);
  };
  looked.furthest = pose(distortion.max);
  const WorstSight& worst = seen.worst();
  looked.most_seen = pose({worst.frame, worst.joint,
                           static_cast<double>(distortion.distances(worst.frame, worst.joint))});
  return looked;
}

Row measure_row(const Encoder& encoder, const std::string& clip, double target_cm) {
  const Motion& motion = encoder.motion();
  const Encoding encoding = encoder.encode({.method = Method::ClosedLoop,
                                            .coding = Coding::Adaptive,
                                            .weighting = Weighting::Surface,
                                            .target = {Target::Kind::Error, target_cm}});
  const Eigen::MatrixXd decoded = body_tracks(motion.skeleton, encoding.decoded);
  const Visibility seen = measure_visibility(motion.skeleton, encoder.original_body(), decoded,
                                             motion.clip.sample_rate_hz, encoder.contacts());
  Row row{clip, target_cm, compression_ratio(motion.clip, encoding.compressed.motion_bytes())};
  row.figures = {encoding.distortion.surface.rms, encoding.distortion.surface.max.cm,
                 seen.worst().times_noticed()};
  for (std::size_t i = 0; i < kCues; ++i) row.times[i] = seen.worst_of[i].times_noticed();
  row.sight = seen.sight();
  row.why = reason(seen.worst(), motion.skeleton);
  row.looked_at = look_at(encoder, encoding.distortion, decoded, seen);
  row.looked_at.title = row.name();
  row.looked_at.figures = "RMS " + significant_text(row.figures[0], 3) + " cm, maximum " +
                          significant_text(row.figures[1], 3) + " cm, " +
                          std::string(name(row.sight)) + ": " +
                          significant_text(row.figures[2], 3) + " times what is noticed";
  row.looked_at.reason = row.why;
  return row;
}

void print(const Row& row) {
  std::printf("| %s | %s | %.1f | %.3f | %.2f | %s | %.2f |", row.clip.c_str(),
              significant_text(row.target_cm, 3).c_str(), row.ratio, row.figures[0], row.figures[1],
              std::string(name(row.sight)).c_str(), row.figures[2]);
  for (const double times : row.times) std::printf(" %.2f |", times);
  std::printf(" %s |\n", row.why.c_str());
  std::fflush(stdout);
}

/// Prints the number of pairs that two figures rank in opposite order, and returns the pair with
/// the largest difference.
std::optional<Disagreement> print_disagreement(const std::vector<Row>& rows, std::size_t a,
                                               std::size_t b) {
  constexpr std::array<const char*, 3> kNames = {"RMS", "maximum", "visibility"};
  int pairs = 0;
  int contrary = 0;
  double most = 1;
  const Row* better = nullptr;  // better by figure a
  const Row* worse = nullptr;
  for (const Row& one : rows)
    for (const Row& other : rows) {
      if (one.figures[a] >= other.figures[a]) continue;
      ++pairs;
      if (one.figures[b] <= other.figures[b]) continue;
      ++contrary;
      const double distance =
          std::min(other.figures[a] / one.figures[a], one.figures[b] / other.figures[b]);
      if (distance <= most) continue;
      most = distance;
      better = &one;
      worse = &other;
    }
  std::printf("| %s, %s | %.0f %% |", kNames[a], kNames[b], 100.0 * contrary / std::max(pairs, 1));
  if (!better) {
    std::printf(" |\n");
    return std::nullopt;
  }
  std::printf(" %s, %s: %.3g to %.3g, but %.3g to %.3g |\n", better->name().c_str(),
              worse->name().c_str(), better->figures[a], worse->figures[a], better->figures[b],
              worse->figures[b]);
  return Disagreement{std::string("Better by ") + kNames[a] + ", worse by " + kNames[b],
                      better->looked_at, worse->looked_at};
}

int run(const std::vector<std::string>& paths, int every, const std::string& page) {
  std::printf("| clip | target, cm | ratio | RMS | max | verdict | times noticed |");
  for (std::size_t i = 0; i < kCues; ++i)
    std::printf(" %s |", std::string(name(static_cast<Cue>(i))).c_str());
  std::printf(" reason |\n|");
  for (std::size_t i = 0; i < kCues + 8; ++i) std::printf(" --- |");
  std::printf("\n");
  std::vector<Row> rows;
  for (const std::string& path : paths)
    for (const auto& clip : clips_of(path)) {
      const Encoder encoder(thinned(read_motion(clip).motion, every));
      for (const double target_cm : kTargets) {
        rows.push_back(measure_row(encoder, clip.stem().string(), target_cm));
        print(rows.back());
      }
    }
  std::printf(
      "\n| verdicts at | not visible | borderline | visible |\n| --- | --- | --- | --- |\n");
  for (const double target_cm : kTargets) {
    std::printf("| %s cm |", significant_text(target_cm, 3).c_str());
    for (const Sight sight : {Sight::NotVisible, Sight::Borderline, Sight::Visible})
      std::printf(" %d |",
                  static_cast<int>(std::count_if(rows.begin(), rows.end(), [&](const Row& row) {
                    return row.target_cm == target_cm && row.sight == sight;
                  })));
    std::printf("\n");
  }
  std::printf("\n| order by | contrary pairs | the most contrary |\n| --- | --- | --- |\n");
  std::vector<Disagreement> all;
  for (const auto& [a, b] : {std::pair(0u, 1u), {0u, 2u}, {1u, 2u}})
    if (auto one = print_disagreement(rows, a, b)) all.push_back(std::move(*one));
  if (page.empty()) return 0;
  std::ofstream out(page);
  out << disagreement_page(all);
  out.close();
  if (!out) throw std::runtime_error("cannot write " + page);
  return 0;
}

}  // namespace
}  // namespace mocapress

int main(int argc, char** argv) {
  std::vector<std::string> paths;
  int every = 1;
  std::string page;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string_view argument = argv[i];
      if (argument == "--every" && i + 1 < argc)
        every = std::stoi(argv[++i]);
      else if (argument == "--page" && i + 1 < argc)
        page = argv[++i];
      else
        paths.emplace_back(argument);
    }
    if (paths.empty() || every < 1) {
      std::fprintf(stderr,
                   "Usage: mocapress-visibility-study CLIP|FOLDER... [--every N] [--page FILE]\n");
      return 2;
    }
    return mocapress::run(paths, every, page);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mocapress-visibility-study: %s\n", error.what());
    return 1;
  }
}
