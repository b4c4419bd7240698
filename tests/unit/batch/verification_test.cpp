// SPDX-License-Identifier: MIT
#include "core/batch/verification.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

const Encoder& original() {
  static const Encoder shared(test::smooth_motion(800));
  return shared;
}

CompressedClip in_segments() {
  EncodeSettings options{.method = Method::ClosedLoop,
                         .weighting = Weighting::BoneEnds,
                         .target = {Target::Kind::Ratio, 30}};
  options.segments = {.longest = 320, .overlap = 24};
  return original().encode(options).compressed;
}

TEST(Verification, IsTheSameSegmentBySegment) {
  const CompressedClip compressed = in_segments();
  ASSERT_TRUE(compressed.segments);
  const std::vector<std::byte> file = write_container(compressed);
  const Verification in_blocks = verify(file, original());
  const Verification whole = verify(file, original(), {.motion = true});
  EXPECT_EQ(in_blocks.by, "runtime");
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
  // The drawn gap is the largest distance, within the 0.1 mm of stored points.
  const auto point = static_cast<std::size_t>(in_blocks.worst.point);
  EXPECT_NEAR((in_blocks.worst.original[point] - in_blocks.worst.decoded[point]).norm(),
              in_blocks.distortion.max.cm, 0.02);
}

TEST(Verification, RefusesBytesThatAreNoFileOrAnothers) {
  const std::vector<std::byte> file = write_container(in_segments());
  EXPECT_THROW(verify(std::span(file).first(file.size() / 2), original()), Error);
  const Encoder shorter(test::smooth_motion(799));
  EXPECT_THROW(verify(file, shorter), Error);
}

TEST(Verification, AnotherSkeletonIsRefused) {
  const Encoding encoding = original().encode({.method = Method::ClosedLoop,
                                               .weighting = Weighting::BoneEnds,
                                               .target = {Target::Kind::Ratio, 30}});
  EXPECT_NO_THROW(verify(write_container(encoding.compressed), original()));
  const auto changed = [&](const std::function<void(Joint&)>& change) {
    CompressedClip clip = encoding.compressed;
    Skeleton skeleton;
    for (Joint joint : clip.skeleton.joints()) {
      if (skeleton.joint_count() == 3) change(joint);
      skeleton.add(std::move(joint));
    }
    clip.skeleton = skeleton;
    return write_container(clip);
  };
  EXPECT_NO_THROW(verify(changed([](Joint&) {}), original()));
  EXPECT_THROW(verify(changed([](Joint& joint) { joint.name += "x"; }), original()), Error);
  EXPECT_THROW(verify(changed([](Joint& joint) { joint.offset.y() += 0.01; }), original()), Error);
  EXPECT_THROW(verify(changed([](Joint& joint) {
                        joint.joint_from_axes = axis_rotation(0, 0.01) * joint.joint_from_axes;
                      }),
                      original()),
               Error);
}

TEST(Verification, IsWhatTheRuntimeDecoderGivesWithTheCorrectionToo) {
  const Motion& motion = original().motion();
  EncodeSettings options{.method = Method::ClosedLoop,
                         .weighting = Weighting::BoneEnds,
                         .target = {Target::Kind::Ratio, 20}};
  options.correction =
      EncodeCorrection{.joints = {motion.skeleton.joint_count() - 1}, .ratio = 8.0};
  options.contacts = {{motion.skeleton.joint_count() - 1, 100, 300}};
  const Encoding encoding = original().encode(options);
  const std::vector<std::byte> file = write_container(encoding.compressed);
  const Verification found =
      verify(file, original(), {.contacts = *options.contacts, .motion = true});
  EXPECT_EQ(found.by, "runtime");
  EXPECT_EQ(found.decoded.channels, decode(read_container(file)).channels);
  EXPECT_NEAR(found.distortion.max.cm, encoding.distortion.max.cm, 1e-3);
  EXPECT_NEAR(found.footskate.total_cm, encoding.footskate.total_cm, 1e-3);
}

TEST(Verification, UsesTheLibraryForClipsThatNoEnginePlays) {
  const Encoding encoding = original().encode({.method = Method::Standard,
                                               .weighting = Weighting::BoneEnds,
                                               .target = {Target::Kind::Ratio, 10}});
  const Verification found = verify(write_container(encoding.compressed), original());
  EXPECT_EQ(found.by, "library");
  EXPECT_EQ(found.distortion.max.cm, encoding.distortion.max.cm);
}

TEST(Verification, IsWithinTheDefaultLimitsOfTheRuntimeDecoder) {
  // A skeleton that core's reader accepts must also be accepted by an engine with default limits.
  Motion motion = test::smooth_motion(4);
  while (motion.skeleton.joint_count() < 1100)
    motion.skeleton.add({.name = "j" + std::to_string(motion.skeleton.joint_count()),
                         .parent = motion.skeleton.joint_count() / 2});
  const Encoder encoder(motion);
  const Encoding encoding = encoder.encode({.method = Method::Standard,
                                            .coding = Coding::Adaptive,
                                            .weighting = Weighting::BoneEnds,
                                            .target = {Target::Kind::CoefficientRatio, 2}});
  EXPECT_EQ(verify(write_container(encoding.compressed), encoder).by, "runtime");
}

}  // namespace
}  // namespace mocapress
