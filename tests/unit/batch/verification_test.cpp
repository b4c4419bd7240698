// SPDX-License-Identifier: MIT
#include "core/batch/verification.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/container.h"
#include "core/codec/decoder.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

const Encoder& original() {
  static const Encoder shared(test::smooth_motion(800));
  return shared;
}

CompressedClip in_segments() {
  EncodeOptions options{.method = Method::ClosedLoop, .target = {Target::Kind::Ratio, 30}};
  options.segments = {.longest = 320, .overlap = 24};
  return original().encode(options).compressed;
}

TEST(Verification, OfSegmentsOneByOneIsThatOfTheWhole) {
  const CompressedClip compressed = in_segments();
  ASSERT_TRUE(compressed.segments);
  const std::vector<std::byte> file = write_container(compressed);
  const Verification in_blocks = verify(file, original(), false);
  const Verification whole = verify(file, original(), true);
  EXPECT_EQ(in_blocks.decoded.frames(), 0);
  EXPECT_EQ(whole.decoded.channels, decode(compressed).channels);
  EXPECT_NEAR(in_blocks.distortion.eps_bone_ends, whole.distortion.eps_bone_ends, 1e-12);
  EXPECT_NEAR(in_blocks.distortion.p95, whole.distortion.p95,
              DistanceCounts::kPrecision * whole.distortion.p95);
  EXPECT_EQ(in_blocks.distortion.max.cm, whole.distortion.max.cm);
  EXPECT_EQ(in_blocks.worst.frame, whole.worst.frame);
  EXPECT_EQ(in_blocks.worst.landmark, whole.worst.landmark);
  EXPECT_EQ(in_blocks.worst.original, whole.worst.original);
  EXPECT_EQ(in_blocks.worst.decoded, whole.worst.decoded);
  EXPECT_EQ(in_blocks.worst.ground_cm, whole.worst.ground_cm);
  // The gap of the drawing is the largest distance, to the 0.1 mm to which it is kept.
  const auto point = static_cast<std::size_t>(in_blocks.worst.point);
  EXPECT_NEAR((in_blocks.worst.original[point] - in_blocks.worst.decoded[point]).norm(),
              in_blocks.distortion.max.cm, 0.02);
}

TEST(Verification, WhatIsNoFileOrAnothersIsRefused) {
  const std::vector<std::byte> file = write_container(in_segments());
  EXPECT_THROW(verify(std::span(file).first(file.size() / 2), original(), false), Error);
  const Encoder shorter(test::smooth_motion(799));
  EXPECT_THROW(verify(file, shorter, false), Error);
}

}  // namespace
}  // namespace mocapress
