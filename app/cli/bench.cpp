// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/global_control.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/motion_input.h"
#include "app/cli/report.h"
#include "core/codec/clip_analysis.h"
#include "core/codec/decoder.h"
#include "core/codec/encoder.h"
#include "core/metrics/distortion.h"
#include "core/select/annealing.h"

namespace mocapress::cli {
namespace {

constexpr double kCoefficientRatio = 20;     // where every stage is measured
constexpr double kRatioWithCorrection = 30;  // with IK, those of the paper's video
constexpr double kCorrectionRatio = 16;

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The best of several runs: what the machine can do, not what else it was doing.
double best_seconds_of(const auto& work) {
  constexpr int kRuns = 20;
  double best = seconds_of(work);
  for (int run = 1; run < kRuns; ++run) best = std::min(best, seconds_of(work));
  return best;
}

/// Solving an IK correction of the feet alone, seconds; unset where there are no feet.
std::optional<double> bench_correction(const Encoder& encoder, IkSolver solver) {
  if (find_feet(encoder.motion().skeleton).empty()) return std::nullopt;
  const Encoding encoding = encoder.encode(
      {.method = Method::Standard,
       .target = {Target::Kind::CoefficientRatio, kRatioWithCorrection},
       .correction = CorrectionOptions{.ratio = kCorrectionRatio, .solver = solver}});
  // The signals are decoded with the motion: here once, and what is measured is their solving.
  const Uncorrected uncorrected = decode_uncorrected(encoding.compressed);
  Clip clip;
  return best_seconds_of([&] {
    clip = uncorrected.clip;  // a copy: nothing beside what is measured
    correct(encoding.compressed, uncorrected.differences, clip);
  });
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
  // The error model is part of the price.
  const double seconds = seconds_of([&] {
    const ErrorModel model(analysis.motion().skeleton, analysis.motion().clip,
                           Weighting::JointOrigins);
    report = anneal(basis.ranked, model, start);
  });
  return {seconds, report.iterations};
}

/// One iteration as the paper has it: every channel gets the coefficients in turn, and full forward
/// kinematics says what came of it.
double bench_reference_iteration(const ClipAnalysis& analysis) {
  const RankedCoefficients& ranked = analysis.in(Basis::Cubic).ranked;
  const Kept kept =
      analysis.in(Basis::Cubic).standard.keep(static_cast<int>(ranked.total() / kCoefficientRatio));
  constexpr int kMoved = 8;
  Clip candidate = analysis.motion().clip;
  for (int c = 0; c < ranked.channels(); ++c)
    candidate.channels.col(c) = synthesise(ranked, c, 0, kept[static_cast<std::size_t>(c)]);
  double best = std::numeric_limits<double>::infinity();
  return seconds_of([&] {
    for (int c = 0; c < ranked.channels(); ++c) {
      const int now = kept[static_cast<std::size_t>(c)];
      const Eigen::VectorXd gain =
          synthesise(ranked, c, now, std::min(now + kMoved, ranked.per_channel()));
      candidate.channels.col(c) += gain;
      best = std::min(best, exact_eps(analysis.motion().skeleton, analysis.original_tracks(),
                                      candidate, Weighting::JointOrigins));
      candidate.channels.col(c) -= gain;
    }
  });
}

Json bench(const Motion& motion) {
  // One thread, so that figures compare with those of others.
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const ClipAnalysis analysis(motion);
  const Encoder encoder(motion);
  const Encoding encoding = encoder.encode(
      {.method = Method::Standard, .target = {Target::Kind::CoefficientRatio, kCoefficientRatio}});
  const double us_per_frame = 1e6 / motion.clip.frames();
  const auto in_us = [&](std::optional<double> seconds) {
    return seconds ? Json(*seconds * us_per_frame) : Json();
  };
  const double decode_seconds = best_seconds_of([&] { (void)decode(encoding.compressed); });
  const Eigen::MatrixXf raw = motion.clip.channels.cast<float>();
  Eigen::MatrixXf copy = raw;
  const double copy_seconds = best_seconds_of([&] {
    std::memcpy(copy.data(), raw.data(), static_cast<std::size_t>(raw.size()) * sizeof(float));
    asm volatile("" : : "r"(copy.data()) : "memory");  // the copy is not optimised away
  });
  const Annealed annealed = bench_annealing(analysis);
  const double reference_seconds = bench_reference_iteration(analysis);
  return {
      {"decode_us_per_frame", decode_seconds * us_per_frame},
      {"copy_us_per_frame", copy_seconds * us_per_frame},
      {"window_us_per_frame", nullptr},
      {"pose_us", nullptr},
      {"ik_us_per_frame", in_us(bench_correction(encoder, IkSolver::NearestPose))},
      {"ik_cyclic_descent_us_per_frame", in_us(bench_correction(encoder, IkSolver::CyclicDescent))},
      {"annealed_seconds", annealed.seconds},
      {"annealed_iterations", annealed.iterations},
      {"annealed_us_per_iteration", 1e6 * annealed.seconds / std::max(annealed.iterations, 1)},
      {"reference_us_per_iteration", 1e6 * reference_seconds},
      {"closed_loop_seconds", nullptr},
      {"closed_loop_frames_per_second", nullptr}};
}

}  // namespace

void add_bench(CLI::App& app) {
  struct Bench {
    std::string clip;
    MotionInput source;
    bool json = false;
  };
  CLI::App* command =
      app.add_subcommand("bench", "Time each stage on a clip, on one thread, beside a reference");
  const auto call = std::make_shared<Bench>();
  command->add_option("clip", call->clip, "A .bvh or .amc file")->required()->type_name("CLIP");
  call->source.add_options(*command);
  command->add_flag("--json", call->json, "Print one JSON object");
  command->callback([call] {
    const Json figures = bench(call->source.read(call->clip));
    if (call->json) return print(figures);
    for (const auto& [key, value] : figures.items())
      if (!value.is_null()) std::fprintf(stderr, "%-28s %s\n", key.c_str(), value.dump().c_str());
  });
}

}  // namespace mocapress::cli
