// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <utility>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/feet/feet.h"
#include "core/metrics/distortion.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"
#include "core/select/annealing.h"

namespace mocapress::cli {
namespace {

constexpr double kErrorCm = 0.5;             // target error of the closed-loop clip
constexpr double kCoefficientRatio = 20;     // ratio at which selections are measured
constexpr double kRatioWithCorrection = 30;  // this and the next: from the paper's video
constexpr double kCorrectionRatio = 16;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time of the fastest of several runs: other work on the machine disturbs it least.
double best_seconds_of(const auto& work) {
  constexpr int kRuns = 20;
  double best = seconds_of(work);
  for (int run = 1; run < kRuns; ++run) best = std::min(best, seconds_of(work));
  return best;
}

/// Measurements of the runtime decoder on a closed-loop clip with adaptive coding. Times are in
/// microseconds.
struct Played {
  double open_us = 0;
  std::size_t resident_bytes = 0;  // without the skeleton
  std::size_t motion_bytes = 0;    // bytes of the motion in the file
  double clip_us_per_frame = 0;
  double window_us_per_frame = 0;
  double pose_us = 0;
  double positions_us_per_frame = 0;
};

/// A clip opened as an engine would.
class OpenClip {
 public:
  explicit OpenClip(const std::vector<std::byte>& file) {
    mcpr_info info;
    mcpr_result result;
    mcpr_inspect(file.data(), file.size(), nullptr, &info, &result);
    require(result);
    motion_bytes_ = info.motion_bytes;
    auto loaded = mcpr::load(file);
    require(loaded.result);
    clip_ = std::move(*loaded);
    scratch_.emplace(std::size_t{1} << 20);
    out_.resize(frames() * std::max(values({}), values({.output = MCPR_POSITIONS})));
  }

  std::uint32_t frames() const { return mcpr::describe(clip_.get()).frames; }
  std::size_t values(const mcpr_request& request) const {
    return mcpr_frame_values(clip_.get(), &request);
  }
  std::size_t motion_bytes() const { return motion_bytes_; }
  std::size_t resident_bytes() const {
    const mcpr_clip_info info = mcpr::describe(clip_.get());
    return info.resident_bytes - info.skeleton_bytes;
  }

  /// Decodes into the same memory at each call.
  void decode(const mcpr_request& request, std::uint32_t first, std::uint32_t count) {
    mcpr_result result;
    mcpr_decode_frames(clip_.get(), &request, first, count, out_.data(), scratch_->data(),
                       scratch_->size(), &result);
    require(result);
  }

 private:
  static void require(const mcpr_result& result) {
    if (result.status != MCPR_OK) throw Error(result.message);
  }

  std::size_t motion_bytes_ = 0;
  std::optional<AlignedBytes> scratch_;
  std::vector<float> out_;
  mcpr::Owned<const mcpr_clip> clip_;
};

/// Seconds per window to decode windows of `count` frames at random places.
double seconds_of_windows(OpenClip& clip, const mcpr_request& request, std::uint32_t count) {
  constexpr int kWindows = 200;
  Random random(1);
  std::vector<std::uint32_t> firsts;
  for (int i = 0; i < kWindows; ++i)
    firsts.push_back(static_cast<std::uint32_t>(random.below(clip.frames() - count + 1)));
  return best_seconds_of([&] {
           for (const std::uint32_t first : firsts) clip.decode(request, first, count);
         }) /
         kWindows;
}

Played bench_decoder(const Encoding& encoding) {
  const std::vector<std::byte> file = write_container(encoding.compressed);
  Played played;
  played.open_us = 1e6 * best_seconds_of([&] { OpenClip{file}; });
  OpenClip clip(file);
  const std::uint32_t frames = clip.frames();
  const std::uint32_t window = std::min<std::uint32_t>(64, frames);
  const auto whole = [&](const mcpr_request& request) {
    return 1e6 * best_seconds_of([&] { clip.decode(request, 0, frames); }) / frames;
  };
  played.resident_bytes = clip.resident_bytes();
  played.motion_bytes = clip.motion_bytes();
  played.clip_us_per_frame = whole({});
  played.window_us_per_frame = 1e6 * seconds_of_windows(clip, {}, window) / window;
  played.pose_us = 1e6 * seconds_of_windows(clip, {}, 1);
  played.positions_us_per_frame = whole({.output = MCPR_POSITIONS});
  return played;
}

/// Microseconds per frame that the IK correction of the feet alone takes; unset without feet.
std::optional<double> bench_correction(const Encoder& encoder, IkSolver solver) {
  if (find_feet(encoder.motion().skeleton).empty()) return std::nullopt;
  const Encoding encoding =
      encoder.encode({.method = Method::Standard,
                      .coding = Coding::Adaptive,
                      .weighting = Weighting::BoneEnds,
                      .target = {Target::Kind::CoefficientRatio, kRatioWithCorrection},
                      .correction = EncodeCorrection{.ratio = kCorrectionRatio, .solver = solver}});
  OpenClip clip(write_container(encoding.compressed));
  const auto seconds = [&](int corrected) {
    return best_seconds_of([&] { clip.decode({.apply_ik = corrected}, 0, clip.frames()); });
  };
  return 1e6 * (seconds(1) - seconds(0)) / clip.frames();
}

struct Annealed {
  double seconds;
  int iterations;
};

Annealed bench_annealing(const ClipAnalysis& analysis) {
  const BasisAnalysis& basis = analysis.in(Basis::Cubic);
  const Kept start =
      basis.standard.keep(static_cast<int>(basis.ranked.total() / kCoefficientRatio));
  AnnealingReport report;
  // The time includes building the error model.
  const double seconds = seconds_of([&] {
    const ErrorModel model(analysis.motion().skeleton, analysis.motion().clip,
                           Weighting::JointOrigins);
    report = anneal(basis.ranked, model, start);
  });
  return {seconds, report.iterations};
}

/// Seconds of one iteration as in the paper: it tries more coefficients for each channel in turn,
/// and measures each result by full forward kinematics.
double bench_reference_iteration(const ClipAnalysis& analysis) {
  const RankedCoefficients& ranked = analysis.in(Basis::Cubic).ranked;
  const Kept kept =
      analysis.in(Basis::Cubic).standard.keep(static_cast<int>(ranked.total() / kCoefficientRatio));
  constexpr int kMoved = 8;
  Clip candidate = analysis.motion().clip;
  for (int c = 0; c < ranked.channels(); ++c)
    candidate.channels.col(c) = synthesise(ranked, c, 0, kept[static_cast<std::size_t>(c)]);
  const Eigen::MatrixXd& tracks = analysis.original_body();
  double best = std::numeric_limits<double>::infinity();
  return seconds_of([&] {
    for (int c = 0; c < ranked.channels(); ++c) {
      const int now = kept[static_cast<std::size_t>(c)];
      const Eigen::VectorXd gain =
          synthesise(ranked, c, now, std::min(now + kMoved, ranked.per_channel()));
      candidate.channels.col(c) += gain;
      best = std::min(
          best, exact_eps(analysis.motion().skeleton, tracks, candidate, Weighting::JointOrigins));
      candidate.channels.col(c) -= gain;
    }
  });
}

/// Seconds of the slowest of several drafts, such as a moving slider asks for, on a clip that is
/// analysed already. If `size_will_do`, the size is estimated, and no bytes are made.
double worst_draft_seconds(const Encoder& encoder, bool size_will_do) {
  double worst = 0;
  for (const double eps_cm : {0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0})
    worst = std::max(worst, seconds_of([&] {
                       encoder.encode({.method = Method::ClosedLoop,
                                       .coding = Coding::Adaptive,
                                       .weighting = Weighting::BoneEnds,
                                       .target = {Target::Kind::Error, eps_cm},
                                       .effort = Effort::Draft,
                                       .size_will_do = size_will_do});
                     }));
  return worst;
}

Json bench(const Motion& motion) {
  // Runs on one thread, so that figures can be compared with published ones.
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ClipAnalysis analysis(motion);
  const Encoder encoder(motion);
  Encoding encoding;
  const double closed_loop_seconds = seconds_of([&] {
    encoding = encoder.encode({.method = Method::ClosedLoop,
                               .coding = Coding::Adaptive,
                               .weighting = Weighting::BoneEnds,
                               .target = {Target::Kind::Error, kErrorCm}});
  });
  const double draft_seconds = worst_draft_seconds(encoder, true);
  const double coded_draft_seconds = worst_draft_seconds(encoder, false);
  const double frames = motion.clip.frames();
  const Played played = bench_decoder(encoding);
  const Eigen::MatrixXf raw = motion.clip.channels.cast<float>();
  Eigen::MatrixXf copy = raw;
  const double copy_seconds = best_seconds_of([&] {
    std::memcpy(copy.data(), raw.data(), static_cast<std::size_t>(raw.size()) * sizeof(float));
    asm volatile("" : : "r"(copy.data()) : "memory");  // keeps the compiler from removing the copy
  });
  const Annealed annealed = bench_annealing(analysis);
  const double reference_seconds = bench_reference_iteration(analysis);
  const auto value = [](const std::optional<double>& figure) {
    return figure ? Json(*figure) : Json();
  };
  return {
      {"decode_us_per_frame", played.clip_us_per_frame},
      {"copy_us_per_frame", 1e6 * copy_seconds / frames},
      {"window_us_per_frame", played.window_us_per_frame},
      {"pose_us", played.pose_us},
      {"positions_us_per_frame", played.positions_us_per_frame},
      {"ik_us_per_frame", value(bench_correction(encoder, IkSolver::NearestPose))},
      {"ik_cyclic_descent_us_per_frame", value(bench_correction(encoder, IkSolver::CyclicDescent))},
      {"open_us", played.open_us},
      {"motion_bytes", played.motion_bytes},
      {"resident_bytes", played.resident_bytes},
      {"annealed_seconds", annealed.seconds},
      {"annealed_iterations", annealed.iterations},
      {"annealed_us_per_iteration", 1e6 * annealed.seconds / std::max(annealed.iterations, 1)},
      {"reference_us_per_iteration", 1e6 * reference_seconds},
      {"closed_loop_seconds", closed_loop_seconds},
      {"closed_loop_frames_per_second", frames / closed_loop_seconds},
      {"draft_ms", 1e3 * draft_seconds},
      {"coded_draft_ms", 1e3 * coded_draft_seconds}};
}

}  // namespace

void add_bench(CLI::App& app) {
  struct Bench {
    std::string clip;
    MotionInput source;
    bool json = false;
  };
  CLI::App* command =
      app.add_subcommand("bench", "Time each stage of encoding and decoding a clip on one thread");
  const auto call = std::make_shared<Bench>();
  command->add_option("clip", call->clip, "Clip to time (.bvh, .amc, .fbx, .gltf or .glb)")
      ->required()
      ->type_name("CLIP");
  call->source.add_options(*command);
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] {
    const Json figures = bench(call->source.read(call->clip));
    if (call->json) return print(figures);
    for (const auto& [key, value] : figures.items())
      if (!value.is_null()) std::fprintf(stderr, "%-28s %s\n", key.c_str(), dumped(value).c_str());
  });
}

}  // namespace mocapress::cli
