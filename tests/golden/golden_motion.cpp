// SPDX-License-Identifier: MIT
#include "tests/golden/golden_motion.h"

#include <cmath>
#include <cstdlib>
#include <span>

#include "core/codec/encode/segmented_encode.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/deflate.h"
#include "core/codec/format/rle16.h"
#include "core/codec/format/varint.h"
#include "core/runtime/format/learned_priors.h"
#include "core/select/ranking.h"
#include "tests/support/turned_forms.h"

namespace mocapress::test {
namespace {

Skeleton golden_skeleton() {
  using enum ChannelKind;
  Skeleton skeleton;
  const int hips = skeleton.add(
      {.name = "hips",
       .channels = {TranslationX, TranslationY, TranslationZ, RotationZ, RotationX, RotationY}});
  const int femur = skeleton.add({.name = "lfemur",
                                  .parent = hips,
                                  .offset = {9.5, -4.25, 0.1},
                                  .joint_from_axes = axis_rotation(2, 0.35) * axis_rotation(0, 0.2),
                                  .channels = {RotationZ, RotationY, RotationX}});
  skeleton.add({.name = "ltibia",
                .parent = femur,
                .offset = {0, -41.3, 0},
                .channels = {RotationX},
                .end_site = Eigen::Vector3d(0, -38.7, 6.25)});
  const int chest = skeleton.add({.name = "chest", .parent = hips, .offset = {0, 33.3, -1.5}});
  skeleton.add({.name = "tête",
                .parent = chest,
                .offset = {0, 21.9, 2.5},
                .channels = {RotationY, RotationX, TranslationY},
                .end_site = Eigen::Vector3d(0, 17.5, 0)});
  return skeleton;
}

/// Takes the same steps as the coding, without output.
struct NoBits {
  static constexpr bool kWrites = true;
  static bool code(bool bit, runtime::Probability) { return bit; }
  void refuse() {}
  static constexpr bool failed() { return false; }
};

}  // namespace

namespace {

Motion golden_motion_of(int frames) {
  Motion motion{golden_skeleton(), {.sample_rate_hz = 60}};
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (int c = 0; c < motion.skeleton.channel_count(); ++c) {
    const double size = is_rotation(motion.skeleton.channel_kind(c)) ? 0.8 : 35;
    for (int t = 0; t < frames; ++t)
      motion.clip.channels(t, c) =
          size * (std::sin(0.05 * (c + 1) * t + c) + 0.1 * std::sin(0.9 * t + 2 * c));
  }
  return motion;
}

}  // namespace

Motion golden_motion() {
  return golden_motion_of(50);
}

CompressedClip golden_clip(Coding coding) {
  const Motion motion = golden_motion();
  const RankedCoefficients ranked = rank_coefficients(motion.clip, Basis::Cubic);
  const std::vector<double> gains = ranked.lifting.gains();
  const Eigen::Map<const Eigen::VectorXd> gain(gains.data(), ranked.per_channel());
  const Kept kept = keep_per_channel(ranked, ranked.total() / 4);
  const Eigen::VectorXd full_precision = Eigen::VectorXd::Zero(ranked.channels());
  std::vector<std::byte> bytes =
      rle16_encode(gain.asDiagonal() * truncate(ranked, kept), full_precision);
  if (coding == Coding::Deflate) bytes = deflate_bytes(bytes);
  return {.skeleton = motion.skeleton,
          .sample_rate_hz = motion.clip.sample_rate_hz,
          .frames = motion.clip.frames(),
          .basis = Basis::Cubic,
          .coding = coding,
          .motion = std::move(bytes),
          .provenance = {.method = Method::PerChannel,
                         .weighting = Weighting::JointOrigins,
                         .seed = 42,
                         .eps_cm = 0.5F,
                         .max_error_cm = 1.5F}};
}

CompressedClip golden_adaptive_clip() {
  const Motion motion = golden_motion();
  const RankedCoefficients ranked = rank_coefficients(motion.clip, Basis::Cubic);
  CompressedClip clip = golden_clip(Coding::Rle16);
  clip.coding = Coding::Adaptive;
  const std::vector<double> alike(static_cast<std::size_t>(ranked.channels()), 1.0);
  clip.motion = pack_adaptive(
      quantise_kept(ranked, alike, keep_per_channel(ranked, ranked.total() / 4), file_scale(0.75)),
      clip);
  return clip;
}

CompressedClip golden_ends_clip() {
  CompressedClip clip = golden_adaptive_clip();
  clip.loop = Loop::Follows;
  CodedEnds ends{.reaches = {{8, 3, 5}}, .step_exponent = {-1, 4, 2}, .steps = {}};
  ends.steps.resize(clip.skeleton.channel_count(), 3);
  for (int c = 0; c < clip.skeleton.channel_count(); ++c)
    ends.steps.row(c) << 3 * c % 11 - 5, -7 * c % 40, 5 * c % 7 - 3;
  clip.ends = std::move(ends);
  return clip;
}

CompressedClip golden_turned_clip() {
  CompressedClip clip = golden_adaptive_clip();
  clip.forms = test::turned_forms(clip.skeleton);
  return clip;
}

CompressedClip golden_segmented_clip() {
  const SegmentLayout layout{540, 256, 64};
  const Motion motion = golden_motion_of(layout.frames);
  CompressedClip clip = golden_clip(Coding::Rle16);
  clip.coding = Coding::Adaptive;
  clip.frames = layout.frames;
  clip.motion.clear();
  clip.segments = CodedSegments{layout.length, layout.overlap, {}};
  for (int k = 0; k < layout.count(); ++k) {
    const Motion part = frames_of(motion, layout.first(k), layout.frames_of(k));
    const RankedCoefficients ranked = rank_coefficients(part.clip, Basis::Cubic);
    const std::vector<double> alike(static_cast<std::size_t>(ranked.channels()), 1.0);
    const std::vector<std::byte> bytes =
        pack_adaptive(quantise_kept(ranked, alike, keep_per_channel(ranked, ranked.total() / 8),
                                    file_scale(0.5 + 0.25 * k)),
                      clip);
    clip.segments->bytes.push_back(static_cast<std::uint32_t>(bytes.size()));
    clip.motion.insert(clip.motion.end(), bytes.begin(), bytes.end());
  }
  return clip;
}

CompressedClip golden_velocity_clip() {
  CompressedClip clip = golden_segmented_clip();
  CodedEnds ends{.reaches = {{2, 9, 6}}, .step_exponent = {3, 0, 5}, .steps = {}};
  ends.steps.resize(clip.skeleton.channel_count(), 3);
  for (int c = 0; c < clip.skeleton.channel_count(); ++c)
    ends.steps.row(c) << 5 * c % 9 - 4, 4 * c % 13 - 6, 7 * c % 30 - 11;
  clip.ends = std::move(ends);
  return clip;
}

CompressedClip golden_corrected_clip() {
  CompressedClip clip = golden_clip(Coding::Rle16);
  Clip differences{clip.sample_rate_hz, Eigen::MatrixXd(clip.frames, 3)};
  for (int t = 0; t < clip.frames; ++t)
    differences.channels.row(t) << 3 * std::sin(0.2 * t), -2 * std::cos(0.11 * t), 0.05 * t;
  const RankedCoefficients ranked = rank_coefficients(differences, clip.basis);
  const auto words = code_signals(ranked, {1, 1, 1}, keep_per_channel(ranked, ranked.total() / 3));
  clip.motion.insert(clip.motion.end(), words.begin(), words.end());
  clip.correction =
      CodedCorrection{.solver = IkSolver::NearestPose,
                      .effectors = {effector_at(clip.skeleton, clip.skeleton.find("ltibia"))}};
  return clip;
}

std::vector<std::byte> golden_lesson() {
  const CompressedClip clip = golden_adaptive_clip();
  QuantisedSignals coded = AdaptiveSegments(clip).next();
  const std::vector<SignalNeighbours> neighbours = signal_neighbours(clip);
  CoefficientModel model(coded.signal_count());
  CoefficientModel before(coded.signal_count());
  NoBits bits;
  code_coefficients(bits, neighbours, *model, coded);
  const auto signals = static_cast<std::uint16_t>(coded.signal_count());
  const auto head = std::as_bytes(std::span(&signals, 1));
  std::vector<std::byte> lesson(head.begin(), head.end());
  for (std::size_t i = 0; i < runtime::MixingSets::kCount * runtime::MixingWeights::kMost; ++i)
    lesson.push_back(static_cast<std::byte>(i % 40 == 0 ? 0xFF : 0));
  int next = 0;
  for (int c = 0; c < model->layout.end; ++c) {
    const runtime::AdaptiveBit& context = model->contexts[c];
    if (context.seen == before->contexts[c].seen) continue;
    const auto off = [&](int step) {
      return std::abs(runtime::squash(runtime::learned_log_odds(static_cast<std::uint8_t>(step))) -
                      context.one);
    };
    int nearest = 0;
    for (int step = 1; step < runtime::kLearnedSteps; ++step)
      if (off(step) < off(nearest)) nearest = step;
    write_varint(lesson, static_cast<std::uint64_t>(c - next));
    lesson.push_back(static_cast<std::byte>(nearest + runtime::kLearnedSteps * (c % 8)));
    next = c + 1;
  }
  return lesson;
}

}  // namespace mocapress::test
