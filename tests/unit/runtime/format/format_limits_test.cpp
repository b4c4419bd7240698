// SPDX-License-Identifier: MIT
// Writers and readers share one set of limits: every written file opens with the decoder's
// defaults.
#include "core/runtime/format/format_limits.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/decode/runtime_clip.h"
#include "core/codec/format/container.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(FormatLimits, AreTheDefaultsOfTheRuntimeDecoder) {
  const mcpr_limits limits = mcpr::default_limits();
  EXPECT_EQ(limits.frames, runtime::kMostFrames);
  EXPECT_EQ(limits.joints, static_cast<std::uint32_t>(runtime::kMostJoints));
  EXPECT_EQ(limits.channels, runtime::kMostChannels);
  EXPECT_EQ(limits.values, runtime::kMostValues);
  EXPECT_EQ(limits.scratch_bytes, runtime::kMostScratchBytes);
  EXPECT_EQ(limits.resident_bytes, runtime::kMostResidentBytes);
}

/// A captured body with fingers and a face: 62 channels.
Motion body(int frames) {
  Motion motion;
  while (motion.skeleton.channel_count() < 60)
    motion.skeleton.add(
        {.name = "j" + std::to_string(motion.skeleton.joint_count()),
         .parent = (motion.skeleton.joint_count() + 1) / 2 - 1,
         .offset = Eigen::Vector3d(1, 20, 0),
         .channels = {ChannelKind::RotationZ, ChannelKind::RotationX, ChannelKind::RotationY}});
  motion.skeleton.add({.name = "hand",
                       .parent = 7,
                       .offset = Eigen::Vector3d(0, 8, 0),
                       .channels = {ChannelKind::RotationX, ChannelKind::RotationZ}});
  const Motion some = test::smooth_motion(frames);
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (Eigen::Index c = 0; c < motion.clip.channels.cols(); ++c)
    motion.clip.channels.col(c) =
        0.4 * some.clip.channels.col(6 + c % (some.clip.channels.cols() - 6));
  return motion;
}

/// A clip of `segments` copies of one segment's bytes, so that only one has to be encoded.
CompressedClip repeated(const CompressedClip& one, int segments, int overlap) {
  CompressedClip clip = one;
  clip.frames = one.frames + (segments - 1) * (one.frames - overlap);
  clip.segments = CodedSegments{one.frames, overlap, {}};
  clip.motion.clear();
  for (int k = 0; k < segments; ++k) {
    clip.motion.insert(clip.motion.end(), one.motion.begin(), one.motion.end());
    clip.segments->bytes.push_back(static_cast<std::uint32_t>(one.motion.size()));
  }
  return clip;
}

TEST(FormatLimits, AdmitAnHourOfABodyAt120Hz) {
  constexpr int kLength = 12288;
  constexpr int kSegments = 33;
  const Motion motion = body(kLength);
  ASSERT_EQ(motion.skeleton.channel_count(), 62);
  const CompressedClip one =
      test::segmented_clip(motion, SegmentLayout::whole(kLength), false, 0.02);
  const CompressedClip clip = repeated(one, kSegments, 48);
  ASSERT_GT(clip.frames, 400000);
  const RuntimeClip opened(write_container(clip));
  EXPECT_EQ(opened.info().frames, static_cast<std::uint32_t>(clip.frames));
  const RuntimeClip alone(write_container(one));
  // Compares frames in the middle of a segment, and the last frames.
  EXPECT_EQ(opened.frames(20 * (kLength - 48) + 6000, 10), alone.frames(6000, 10));
  EXPECT_EQ(opened.frames(clip.frames - 10, 10), alone.frames(kLength - 10, 10));
}

TEST(FormatLimits, AdmitHoursOfStillness) {
  CompressedClip clip{.frames = 1 << 22, .coding = Coding::Adaptive, .motion = {}};
  clip.provenance.method = Method::ClosedLoop;
  clip.skeleton.add(
      {.name = "stone",
       .channels = {ChannelKind::RotationX, ChannelKind::RotationY, ChannelKind::RotationZ}});
  clip.motion = pack_adaptive(
      {.step_exponent = std::vector<int>(3), .values = Eigen::MatrixXi::Zero(clip.frames, 3)},
      clip);
  ASSERT_LT(clip.motion.size(), 100u);
  const RuntimeClip opened(write_container(clip));
  EXPECT_EQ(opened.frames(clip.frames - 2, 2), Eigen::MatrixXd::Zero(2, 3));
}

TEST(FormatLimits, TheLargestSkeletonOpens) {
  CompressedClip clip{.frames = 3, .coding = Coding::Adaptive, .motion = {}};
  clip.provenance.method = Method::ClosedLoop;
  for (int j = 0; j < runtime::kMostJoints; ++j)
    clip.skeleton.add({.name = std::string(j % 16 == 0 ? runtime::kMostNameBytes : 4, 'n'),
                       .parent = (j + 1) / 2 - 1,
                       .channels = std::vector<ChannelKind>(6, ChannelKind::RotationX)});
  clip.motion = pack_adaptive({.step_exponent = std::vector<int>(6 * runtime::kMostJoints),
                               .values = Eigen::MatrixXi::Zero(3, 6 * runtime::kMostJoints)},
                              clip);
  const std::vector<std::byte> file = write_container(clip);
  EXPECT_EQ(read_container(file).skeleton.joint_count(), runtime::kMostJoints);
  const RuntimeClip opened(file);
  EXPECT_EQ(opened.info().channels, runtime::kMostChannels);
  EXPECT_TRUE(opened.has_joints_of(clip.skeleton));
  EXPECT_EQ(opened.frames(0, 3), Eigen::MatrixXd::Zero(3, runtime::kMostChannels));
}

}  // namespace
}  // namespace mocapress
