// SPDX-License-Identifier: MIT
// Samples a clip of more columns than fit on the stack, which needs memory of the caller's.
#include "core/runtime/pose/pose_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/file.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::pose_sampler_test {
namespace {

/// 400 joints, each of which turns about three axes.
class LargeClip : public testing::Test {
 protected:
  void SetUp() override { ASSERT_NE(cooked_.clip, nullptr) << cooked_.result.message; }

  std::vector<float> sampled(mcpr_sample_request request, double frame,
                             mcpr_cursor* cursor = nullptr) const {
    const AlignedBytes scratch(mcpr_sample_scratch_bytes(cooked_.clip, &request));
    request.scratch = scratch.data();
    request.scratch_size = scratch.size();
    std::vector<float> out(mcpr_sample_values(cooked_.clip, &request));
    mcpr_result result;
    const mcpr_status status = cursor == nullptr
                                   ? mcpr_sample(cooked_.clip, &request, frame, out.data(), &result)
                                   : mcpr_sample_next(cursor, &request, frame, out.data(), &result);
    EXPECT_EQ(status, MCPR_OK) << result.message;
    return out;
  }

  /// Compares a pose of transforms with mcpr_decode_moment, within what SAMPLING.md promises.
  void expect_as_decoded(const std::vector<float>& pose, double frame) const {
    const std::vector<float> decoded = opened_.moment({.output = MCPR_LOCAL}, frame);
    ASSERT_EQ(pose.size() / 8, decoded.size() / 7);
    for (std::size_t j = 0; j < pose.size() / 8; ++j) {
      float dot = 0;
      for (std::size_t k = 0; k < 4; ++k) dot += pose[8 * j + k] * decoded[7 * j + k];
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(pose[8 * j + k], std::copysign(1.0F, dot) * decoded[7 * j + k], 2.5e-4);
      for (std::size_t k = 4; k < 7; ++k)
        EXPECT_NEAR(pose[8 * j + k], decoded[7 * j + k], 2e-3) << j;
    }
  }

  static constexpr std::uint16_t kList[] = {399, 0, 210};
  static constexpr std::uint16_t kStepped[] = {0, 399};
  const test::OpenedClip opened_{read_bytes(std::string(MOCAPRESS_SOURCE_DIR) +
                                            "/tests/fuzz/corpus/runtime/many_joints.mcpr")};
  const test::CookedClip cooked_{opened_.clip};
};

TEST_F(LargeClip, IsRefusedWithoutTheMemoryThatItAsksFor) {
  mcpr_sample_request request{};
  const std::size_t bytes = mcpr_sample_scratch_bytes(cooked_.clip, &request);
  EXPECT_GT(bytes, 0U);
  std::vector<float> out(mcpr_sample_values(cooked_.clip, &request));
  const AlignedBytes scratch(bytes + 32);
  mcpr_transform moved;
  const auto expect = [&](void* memory, std::size_t size, mcpr_status status) {
    request.scratch = memory;
    request.scratch_size = size;
    EXPECT_EQ(mcpr_sample(cooked_.clip, &request, 3.5, out.data(), nullptr), status);
  };
  expect(nullptr, 0, MCPR_NO_MEMORY);
  EXPECT_EQ(mcpr_sample_motion(cooked_.clip, &request, 0, 0, 1, &moved, nullptr), MCPR_NO_MEMORY);
  expect(scratch.data(), bytes - 1, MCPR_MEMORY);
  expect(scratch.data() + 1, bytes, MCPR_MISALIGNED);
  expect(scratch.data(), bytes, MCPR_OK);
}

TEST_F(LargeClip, NeedsNoMoreMemoryThanTheHeaderTells) {
  const std::vector<std::uint16_t> all = [] {
    std::vector<std::uint16_t> joints(400);
    for (std::size_t j = 0; j < joints.size(); ++j) joints[j] = static_cast<std::uint16_t>(j);
    return joints;
  }();
  const mcpr_sample_request request{
      .joints = all.data(), .joint_count = 400, .stepped = all.data(), .stepped_count = 400};
  EXPECT_LE(mcpr_sample_scratch_bytes(cooked_.clip, &request), std::size_t{64} << 10);
  const std::vector<float> stepped = sampled(request, 7.5);
  EXPECT_EQ(stepped, sampled({.joints = all.data(), .joint_count = 400}, 7));
}

TEST_F(LargeClip, HasTheDecodersPosesAndTheSameBitsOnEveryPath) {
  const AlignedBytes memory(mcpr_cursor_bytes(cooked_.clip));
  mcpr_cursor* cursor = nullptr;
  ASSERT_EQ(mcpr_make_cursor(cooked_.clip, memory.data(), memory.size(), &cursor, nullptr),
            MCPR_OK);
  for (double frame = 0; frame <= 29; frame += 0.75) {
    const std::vector<float> pose = sampled({}, frame);
    expect_as_decoded(pose, frame);
    expect_as_decoded(sampled({}, frame, cursor), frame);
    for (const mcpr_path path : existing_paths())
      EXPECT_EQ(sampled({.path = path}, frame), pose) << path << " at " << frame;
  }
}

TEST_F(LargeClip, ListsAndSteppedJointsAreThoseOfTheWholePose) {
  const std::vector<float> pose = sampled({}, 11.25);
  const std::vector<float> at_frame = sampled({}, 11);
  const std::vector<float> listed =
      sampled({.joints = kList, .joint_count = 3, .stepped = kStepped, .stepped_count = 2}, 11.25);
  ASSERT_EQ(listed.size(), 24U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<float>& whole = kList[i] == 210 ? pose : at_frame;
    EXPECT_TRUE(std::equal(&listed[8 * i], &listed[8 * i] + 8, &whole[8UL * kList[i]])) << i;
  }
}

TEST_F(LargeClip, ACrowdPosesItWithoutMemoryOfItsOwn) {
  std::vector<float> out(std::size_t{8} * 400);
  mcpr_character character{};
  character.clip = cooked_.clip;
  character.time = 11.25;
  character.out = out.data();
  character.stepped = kStepped;
  character.stepped_count = 2;
  const mcpr_crowd_request request{.exact = 1};
  const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
  ASSERT_EQ(mcpr_sample_crowd(&request, &character, 1, scratch.data(), scratch.size(), nullptr),
            MCPR_OK);
  EXPECT_EQ(out, sampled({.stepped = kStepped, .stepped_count = 2}, 11.25));
}

TEST_F(LargeClip, MotionOfItsRootIsTheDifferenceOfPoses) {
  mcpr_sample_request request{};
  const AlignedBytes scratch(std::size_t{64} << 10);
  request.scratch = scratch.data();
  request.scratch_size = scratch.size();
  mcpr_transform moved;
  ASSERT_EQ(mcpr_sample_motion(cooked_.clip, &request, 0, 2, 20, &moved, nullptr), MCPR_OK);
  const std::vector<float> from = sampled({}, 2);
  const std::vector<float> to = sampled({}, 20);
  float length = 0, expected = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    length += moved.translation[k] * moved.translation[k];
    expected += (to[4 + k] - from[4 + k]) * (to[4 + k] - from[4 + k]);
  }
  EXPECT_NEAR(std::sqrt(length), std::sqrt(expected), 1e-3);
}

}  // namespace
}  // namespace mocapress::pose_sampler_test
