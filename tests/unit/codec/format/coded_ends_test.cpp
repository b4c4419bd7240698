// SPDX-License-Identifier: MIT
#include "core/codec/format/coded_ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/format/format_error.h"

namespace mocapress {
namespace {

constexpr int kChannelsOfClip = 20;
constexpr int kFramesOfClip = 100;

CodedEnds some_ends() {
  Random random(3);
  CodedEnds ends{.reaches = {{8, 1}}, .step_exponent = {-3, 12}, .steps = {}};
  ends.steps.resize(kChannelsOfClip, 2);
  for (int& steps : ends.steps.reshaped()) steps = static_cast<int>(random.below(41)) - 20;
  ends.steps(4, 0) = (1 << 24) - 1;
  ends.steps(5, 1) = -((1 << 24) - 1);
  return ends;
}

CodedEnds ends_with_velocity() {
  CodedEnds ends = some_ends();
  ends.reaches.frames[runtime::kVelocity] = 16;
  ends.step_exponent[runtime::kVelocity] = 5;
  ends.steps.conservativeResize(Eigen::NoChange, runtime::kMostEnds);
  for (Eigen::Index c = 0; c < kChannelsOfClip; ++c)
    ends.steps(c, runtime::kVelocity) = 1 + static_cast<int>(c) % 7;
  return ends;
}

/// As a reader of a clip of so many frames does.
CodedEnds read_back(const std::vector<std::byte>& payload, std::uint32_t frames) {
  runtime::FileSections sections{.frames = frames, .channels = kChannelsOfClip};
  require(runtime::read_ends(
      {reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size(), 0}, sections));
  return read_ends(sections);
}

TEST(CodedEnds, ReadBackAsWritten) {
  for (const CodedEnds& ends : {some_ends(), ends_with_velocity()}) {
    const CodedEnds read = read_back(ends.write(), kFramesOfClip);
    EXPECT_TRUE(std::ranges::equal(read.reaches.frames, ends.reaches.frames));
    EXPECT_EQ(read.step_exponent, ends.step_exponent);
    EXPECT_EQ(read.steps, ends.steps);
  }
}

TEST(CodedEnds, BytesAfterThemAreRefused) {
  std::vector<std::byte> bytes = some_ends().write();
  bytes.resize(bytes.size() + 4);
  EXPECT_THROW(read_back(bytes, kFramesOfClip), FormatError);
}

TEST(CodedEnds, EndsOfMoreFramesThanTheClipAreRefused) {
  const std::vector<std::byte> bytes = some_ends().write();
  EXPECT_NO_THROW(read_back(bytes, 8));
  EXPECT_THROW(read_back(bytes, 7), FormatError);
}

TEST(CodedEnds, ImpossibleStepsAndReachesAreRefused) {
  for (const std::size_t byte : {0u, 1u}) {
    std::vector<std::byte> bytes = some_ends().write();
    bytes[byte] = std::byte{0};
    EXPECT_THROW(read_back(bytes, kFramesOfClip), FormatError);
  }
  for (const int reach : {0, 101, 128, 255}) {  // the velocity's
    std::vector<std::byte> bytes = ends_with_velocity().write();
    bytes[4] = static_cast<std::byte>(reach);
    EXPECT_THROW(read_back(bytes, kFramesOfClip), FormatError);
  }
  for (const std::size_t byte : {2u, 3u})
    for (const int step_exponent : {-17, 49}) {
      std::vector<std::byte> bytes = some_ends().write();
      bytes[byte] = static_cast<std::byte>(step_exponent);
      EXPECT_THROW(read_back(bytes, kFramesOfClip), FormatError);
    }
}

TEST(CodedEnds, AVelocityAtTheFirstEndIsRefused) {
  std::vector<std::byte> bytes = ends_with_velocity().write();
  bytes[0] |= std::byte{runtime::kVelocityFollows};
  EXPECT_THROW(read_back(bytes, kFramesOfClip), FormatError);
}

TEST(EndPoses, TakeEffectWithinTheirReachAndWholeAtTheEnds) {
  const CodedEnds ends = some_ends();
  const std::vector<float> steps(kChannelsOfClip, 0.25F);
  Eigen::MatrixXd channels = Eigen::MatrixXd::Zero(kFramesOfClip, kChannelsOfClip);
  EndPoses(ends, steps, steps).add_to(0, kFramesOfClip, channels);
  EXPECT_EQ(channels(kFramesOfClip - 1, 0), 0.25 * std::exp2(-6) * ends.steps(0, 1));
  for (int t = 0; t < 8; ++t) {
    const double left = (8.0 - t) / 8;
    EXPECT_NEAR(channels(t, 0), left * left * channels(0, 0), 1e-6);
  }
  EXPECT_TRUE(channels.middleRows(8, kFramesOfClip - 9).isZero(0));
}

TEST(EndPoses, AVelocityKeepsTheLastFrameAndChangesTheOneBefore) {
  CodedEnds ends = ends_with_velocity();
  ends.steps.leftCols(2).setZero();
  const std::vector<float> first_steps(kChannelsOfClip, 0.25F);
  const std::vector<float> last_steps(kChannelsOfClip, 0.5F);
  Eigen::MatrixXd channels = Eigen::MatrixXd::Zero(kFramesOfClip, kChannelsOfClip);
  EndPoses(ends, first_steps, last_steps).add_to(0, kFramesOfClip, channels);
  const Eigen::MatrixXd backwards = channels.colwise().reverse();
  const double velocity = 0.5 * std::exp2(-2.5) * ends.steps(0, 2);
  for (int away = 0; away < 16; ++away) {
    const double left = (16.0 - away) / 16;
    EXPECT_NEAR(backwards(away, 0), away * left * left * velocity, 1e-5);
  }
  EXPECT_TRUE(backwards.bottomRows(kFramesOfClip - 16).isZero(0));
}

TEST(EndPoses, AreTheSameInBlocks) {
  const CodedEnds ends = ends_with_velocity();
  const std::vector<float> steps(kChannelsOfClip, 0.25F);
  const EndPoses poses(ends, steps, steps);
  Eigen::MatrixXd whole = Eigen::MatrixXd::Ones(kFramesOfClip, kChannelsOfClip);
  poses.add_to(0, kFramesOfClip, whole);
  for (const int first : {0, 3, 97, 99}) {
    Eigen::MatrixXd block =
        Eigen::MatrixXd::Ones(std::min(5, kFramesOfClip - first), kChannelsOfClip);
    poses.add_to(first, kFramesOfClip, block);
    EXPECT_EQ(block, whole.middleRows(first, block.rows()));
  }
}

}  // namespace
}  // namespace mocapress
