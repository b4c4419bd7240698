// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/important_range.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "core/metrics/distortion.h"
#include "core/motion/body_tracks.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::important_range_test {
namespace {

const Encoder& walk() {
  static const Encoder shared(samples::walk_clip());
  return shared;
}

/// The middle fifth of the walk.
ImportantRange middle(double factor) {
  const int frames = walk().motion().clip.frames();
  return {2 * frames / 5, 3 * frames / 5 - 1, factor};
}

/// Squared errors (cm^2) of each frame and point of the surface.
Eigen::MatrixXd squared_errors(const Encoding& encoding) {
  const Skeleton& skeleton = walk().motion().skeleton;
  return PointErrors(skeleton, Weighting::Surface)
      .squared(walk().original_body(), body_tracks(skeleton, encoding.decoded));
}

double rms_within(const ImportantRange& range, const Encoding& encoding) {
  const Eigen::VectorXd weights =
      measured_points(walk().motion().skeleton, Weighting::Surface).weights;
  const Eigen::VectorXd of_frames = squared_errors(encoding) * weights;
  return std::sqrt(
      of_frames.segment(range.first_frame, range.last_frame - range.first_frame + 1).mean());
}

double worst_within(const ImportantRange& range, const Encoding& encoding) {
  return std::sqrt(squared_errors(encoding)
                       .middleRows(range.first_frame, range.last_frame - range.first_frame + 1)
                       .maxCoeff());
}

Encoding encoded(const Target& target, std::vector<ImportantRange> ranges,
                 const SegmentPlan& segments = {}) {
  return walk().encode({.target = target, .ranges = std::move(ranges), .segments = segments});
}

TEST(ImportantRange, FactorsAreTheLargestOfEachFrame) {
  const Eigen::VectorXd factors = frame_factors({{1, 3, 2}, {3, 3, 5}}, 6);
  EXPECT_EQ(factors, (Eigen::VectorXd(6) << 1, 2, 2, 5, 1, 1).finished());
  EXPECT_EQ(frame_factors({}, 6).size(), 0);
}

TEST(ImportantRange, AFrameThatTheClipLacksIsRefused) {
  for (const ImportantRange& wrong :
       {ImportantRange{0, 6, 2}, ImportantRange{-1, 3, 2}, ImportantRange{4, 3, 2},
        ImportantRange{0, 3, 0.5}, ImportantRange{0, 3, 101}, ImportantRange{0, 3, std::nan("")}})
    EXPECT_THROW(frame_factors({wrong}, 6), Error);
  EXPECT_THROW(encoded({Target::Kind::Error, 0.5}, {{0, walk().motion().clip.frames(), 2}}), Error);
}

TEST(ImportantRange, PartsAreCountedFromTheFirstFrame) {
  const std::vector<ImportantRange> ranges = {{2, 9, 3}, {20, 30, 2}};
  EXPECT_EQ(frames_of(ranges, 5, 10), (std::vector<ImportantRange>{{0, 4, 3}}));
  EXPECT_EQ(frames_of(ranges, 0, 25), (std::vector<ImportantRange>{{2, 9, 3}, {20, 24, 2}}));
}

TEST(ImportantRange, TheErrorInItIsAboutAsManyTimesSmaller) {
  const Target target{Target::Kind::Error, 0.5};
  const Encoding plain = encoded(target, {});
  for (const double factor : {2.0, 4.0}) {
    const Encoding careful = encoded(target, {middle(factor)});
    const double times = rms_within(middle(factor), plain) / rms_within(middle(factor), careful);
    EXPECT_GT(times, 0.8 * factor);
    EXPECT_LT(times, 1.6 * factor);
    EXPECT_LE(careful.distortion.eps(Weighting::Surface), target.value);
    EXPECT_GT(careful.compressed.motion_bytes(), plain.compressed.motion_bytes());
  }
}

TEST(ImportantRange, AHardMaximumIsAsManyTimesSmallerInIt) {
  const Target target{Target::Kind::MaxError, 2};
  const Encoding careful = encoded(target, {middle(4)});
  EXPECT_LE(worst_within(middle(4), careful), target.value / 4 * 1.0001);
  EXPECT_LE(careful.distortion.worst(Weighting::Surface).cm, target.value * 1.0001);
  EXPECT_GT(worst_within(middle(4), encoded(target, {})), target.value / 4);
}

TEST(ImportantRange, AtOneSizeTheErrorMovesOutOfIt) {
  const Target target{Target::Kind::Ratio, 100};
  EXPECT_LT(rms_within(middle(3), encoded(target, {middle(3)})),
            0.75 * rms_within(middle(3), encoded(target, {})));
}

TEST(ImportantRange, AVisibilityTargetIsAsManyTimesStricterInIt) {
  const auto noticed = [](const Encoding& encoding) {
    const SightTable& table = encoding.visibility.table;
    const int first = table.window_of(middle(1).first_frame);
    const int last = table.window_of(middle(1).last_frame);
    return table.times_noticed.middleRows(first, last - first + 1).maxCoeff();
  };
  const Target target{Target::Kind::Visibility, 1};
  EXPECT_LE(noticed(encoded(target, {middle(2)})), 0.5001F);
  EXPECT_GT(noticed(encoded(target, {})), 0.5001F);
}

TEST(ImportantRange, ReachesOverSegments) {
  const Target target{Target::Kind::Error, 0.5};
  const SegmentPlan segments{.longest = 256, .overlap = 16};
  const Encoding plain = encoded(target, {}, segments);
  ASSERT_GT(plain.compressed.segments->bytes.size(), 1U);
  const Encoding careful = encoded(target, {middle(3)}, segments);
  EXPECT_GT(rms_within(middle(3), plain) / rms_within(middle(3), careful), 1.8);
}

}  // namespace
}  // namespace mocapress::important_range_test
