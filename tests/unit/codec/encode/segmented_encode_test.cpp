// SPDX-License-Identifier: MIT
#include "core/codec/encode/segmented_encode.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "core/metrics/rate.h"
#include "resources/samples/generator/samples.h"

namespace mocapress {
namespace {

constexpr int kFrames = 800;

/// A walk there and back again.
Motion long_walk() {
  const Motion walk = samples::walk_clip();
  const int once = walk.clip.frames();
  Motion longer{walk.skeleton, {walk.clip.sample_rate_hz, {}}};
  longer.clip.channels.resize(kFrames, walk.clip.channels.cols());
  for (int t = 0; t < kFrames; ++t) {
    const int in_two = t % (2 * once);
    longer.clip.channels.row(t) =
        walk.clip.channels.row(in_two < once ? in_two : 2 * once - 1 - in_two);
  }
  return longer;
}

const Encoder& walk() {
  static const Encoder shared(long_walk());
  return shared;
}

EncodeOptions options(Target target, int longest = 320) {
  EncodeOptions made{.method = Method::ClosedLoop, .target = target};
  made.segments = {.longest = longest, .overlap = 24};
  return made;
}

TEST(SegmentedEncode, MeetsEveryKindOfTarget) {
  const auto encoded = [](Target target) { return walk().encode(options(target)); };
  const auto raw = static_cast<double>(raw_bytes(walk().motion().clip));
  const Encoding by_error = encoded({Target::Kind::Error, 0.3});
  EXPECT_EQ(by_error.compressed.segment_layout().count(), 3);
  EXPECT_LE(by_error.distortion.eps_bone_ends, 0.3);
  EXPECT_GT(by_error.distortion.eps_bone_ends, 0.96 * 0.3);
  const Encoding by_ratio = encoded({Target::Kind::Ratio, 60});
  EXPECT_NEAR(raw / static_cast<double>(by_ratio.compressed.motion_bytes()) / 60, 1, 0.02);
  const auto size = encoded({Target::Kind::Size, 4000}).compressed.motion_bytes();
  EXPECT_LE(size, 4000u);
  EXPECT_GT(size, 3840u);
}

TEST(SegmentedEncode, HoldsAHardMaximum) {
  for (const bool corrected : {false, true}) {
    EncodeOptions asked = options({Target::Kind::MaxError, 2});
    if (corrected) asked.correction.emplace().ratio = 16;
    const double max_cm = walk().encode(asked).distortion.max.cm;
    EXPECT_LE(max_cm, 2);
    // The cheapest found, which need not be the nearest: what a solver makes of a coarser motion
    // jumps.
    EXPECT_GT(max_cm, (corrected ? 0.9 : 0.97) * 2);
  }
}

TEST(SegmentedEncode, LeavesNothingToSee) {
  const Encoding encoding = walk().encode(options({Target::Kind::Visibility, 1}));
  EXPECT_EQ(encoding.visibility.sight(), Sight::NotVisible);
  EXPECT_GT(encoding.visibility.worst().times_noticed(), 0.75);
}

TEST(SegmentedEncode, WhatIsMeasuredIsWhatTheFileDecodesTo) {
  const Encoding encoding = walk().encode(options({Target::Kind::Ratio, 60}));
  const CompressedClip read = read_container(write_container(encoding.compressed));
  EXPECT_EQ(read.segments->bytes.size(), 3u);
  EXPECT_EQ(decode(read).channels, encoding.decoded.channels);
}

TEST(SegmentedEncode, AShortClipIsNotCut) {
  const Encoding whole = walk().encode(options({Target::Kind::Ratio, 60}, kFrames));
  EXPECT_FALSE(whole.compressed.segments);
  const Encoding usual =
      walk().encode({.method = Method::ClosedLoop, .target = {Target::Kind::Ratio, 60}});
  EXPECT_EQ(whole.compressed.motion, usual.compressed.motion);
}

TEST(SegmentedEncode, GivesTheSameBytesOnAnyNumberOfThreads) {
  const EncodeOptions ratio = options({Target::Kind::Ratio, 60});
  const Encoding many = walk().encode(ratio);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(write_container(Encoder(long_walk()).encode(ratio).compressed),
            write_container(many.compressed));
}

TEST(SegmentedEncode, CancelledItGivesAClipThatDecodes) {
  for (const int after : {1, 7, 25}) {
    int calls = 0;
    const Encoding cut = walk().encode(options({Target::Kind::Error, 0.3}),
                                       [&](const EncodeProgress&) { return ++calls < after; });
    EXPECT_FALSE(cut.complete);
    EXPECT_EQ(calls, after) << "asked again after it was told to end";
    EXPECT_EQ(decode(read_container(write_container(cut.compressed))).frames(), kFrames);
  }
}

TEST(SegmentedEncode, ProgressGoesForwardThroughPassesAndSegments) {
  EncodeProgress before{.pass = 0, .iteration = 0};
  walk().encode(options({Target::Kind::Error, 0.3}), [&](const EncodeProgress& progress) {
    EXPECT_TRUE(progress.pass > before.pass ||
                (progress.pass == before.pass && progress.iteration > before.iteration));
    before = progress;
    return true;
  });
  EXPECT_GE(before.pass, 1);
}

TEST(SegmentedEncode, CorrectsTheSameFeetInEverySegment) {
  EncodeOptions corrected = options({Target::Kind::Ratio, 60});
  corrected.correction.emplace();
  const Encoding with = walk().encode(corrected);
  ASSERT_TRUE(with.correction);
  EXPECT_NEAR(compression_ratio(walk().motion().clip, with.compressed.motion_bytes()) / 60, 1,
              0.02);
  EXPECT_EQ(with.compressed.correction->effectors.size(), 2u);
  EXPECT_GT(with.compressed.correction_bytes(), 50u);
  const Encoding without = walk().encode(options({Target::Kind::Ratio, 60}));
  EXPECT_LT(with.footskate.total_cm, without.footskate.total_cm);
}

TEST(SegmentedEncode, HeedsContactsInEverySegment) {
  EncodeOptions planted = options({Target::Kind::Ratio, 60});
  planted.importance.contacts = 20;
  EXPECT_LT(walk().encode(planted).footskate.total_cm,
            walk().encode(options({Target::Kind::Ratio, 60})).footskate.total_cm);
}

TEST(SegmentedEncode, SeamsHaveNoMoreErrorThanElsewhereAndDoNotJump) {
  const Motion& motion = walk().motion();
  for (const double eps : {0.5, 0.1}) {
    const Encoding encoding = walk().encode(options({Target::Kind::Error, eps}));
    const SegmentLayout layout = encoding.compressed.segment_layout();
    const Eigen::MatrixXd error =
        landmark_tracks(motion.skeleton, encoding.decoded) - walk().original_tracks();
    struct {
      double squares = 0;
      double velocity_squares = 0;
      double largest = 0;
      double largest_velocity = 0;
      int frames = 0;
      double rms() const { return std::sqrt(squares / frames); }
      double velocity_rms() const { return std::sqrt(velocity_squares / frames); }
    } seam, elsewhere;
    for (int t = 1; t < layout.frames; ++t) {
      const bool at_seam = layout.stretch_at(t).shared >= 0 || layout.stretch_at(t - 1).shared >= 0;
      const Eigen::RowVectorXd velocity = error.row(t) - error.row(t - 1);
      auto& errors = at_seam ? seam : elsewhere;
      errors.squares += error.row(t).squaredNorm();
      errors.velocity_squares += velocity.squaredNorm();
      errors.largest = std::max(errors.largest, error.row(t).cwiseAbs().maxCoeff());
      errors.largest_velocity = std::max(errors.largest_velocity, velocity.cwiseAbs().maxCoeff());
      ++errors.frames;
    }
    EXPECT_LT(seam.rms(), 1.1 * elsewhere.rms());
    EXPECT_LT(seam.velocity_rms(), 1.1 * elsewhere.velocity_rms());
    EXPECT_LE(seam.largest, elsewhere.largest);
    EXPECT_LE(seam.largest_velocity, elsewhere.largest_velocity);
  }
}

/// The same figures, percentiles to the precision they have without distances.
void expect_same_figures(const Encoding& figures, const Encoding& whole) {
  EXPECT_EQ(figures.distortion.eps_bone_ends, whole.distortion.eps_bone_ends);
  EXPECT_EQ(figures.distortion.eps_joint_origins, whole.distortion.eps_joint_origins);
  EXPECT_EQ(figures.distortion.max.cm, whole.distortion.max.cm);
  EXPECT_EQ(figures.distortion.max.frame, whole.distortion.max.frame);
  EXPECT_NEAR(figures.distortion.p95, whole.distortion.p95,
              DistanceCounts::kPrecision * whole.distortion.p95);
  EXPECT_NEAR(figures.distortion.p99, whole.distortion.p99,
              DistanceCounts::kPrecision * whole.distortion.p99);
  EXPECT_EQ(figures.footskate.total_cm, whole.footskate.total_cm);
  EXPECT_EQ(figures.coefficient_ratio, whole.coefficient_ratio);
}

TEST(SegmentedEncode, AskedForFiguresAloneItGivesTheSameBytesAndFigures) {
  for (const int longest : {320, kFrames})
    for (const bool corrected : {false, true}) {
      EncodeOptions asked = options({Target::Kind::Ratio, 60}, longest);
      if (corrected) asked.correction.emplace().ratio = 16;
      const Encoding whole = walk().encode(asked);
      asked.figures_only = true;
      const Encoding figures = walk().encode(asked);
      EXPECT_EQ(write_container(figures.compressed), write_container(whole.compressed));
      expect_same_figures(figures, whole);
      EXPECT_EQ(whole.decoded.frames(), kFrames);
      EXPECT_EQ(whole.distortion.distances.rows(), kFrames);
      EXPECT_EQ(figures.decoded.frames(), 0);
      EXPECT_EQ(figures.distortion.distances.size(), 0);
      ASSERT_EQ(figures.correction.has_value(), corrected);
      if (!corrected) continue;
      EXPECT_EQ(figures.correction->fastest_knee, whole.correction->fastest_knee);
      EXPECT_EQ(figures.correction->report.iterations, whole.correction->report.iterations);
      EXPECT_EQ(figures.correction->uncorrected.frames(), 0);
      EXPECT_EQ(whole.correction->uncorrected.channels,
                decode_uncorrected(whole.compressed).clip.channels);
    }
}

TEST(SegmentedEncode, WhatIsMeasuredInBlocksIsWhatTheWholeMeasures) {
  const Encoding encoding = walk().encode(options({Target::Kind::Ratio, 60}));
  const Motion& motion = walk().motion();
  const Distortion whole = measure(motion.skeleton, walk().original_body(), encoding.decoded);
  EXPECT_NEAR(encoding.distortion.eps_bone_ends, whole.eps_bone_ends, 1e-12);
  EXPECT_EQ(encoding.distortion.max.cm, whole.max.cm);
  EXPECT_TRUE(encoding.distortion.distances == whole.distances);
  EXPECT_EQ(encoding.footskate.total_cm,
            measure_footskate(walk().contacts(), walk().original_tracks(),
                              landmark_tracks(motion.skeleton, encoding.decoded),
                              motion.clip.sample_rate_hz)
                .total_cm);
}

}  // namespace
}  // namespace mocapress
