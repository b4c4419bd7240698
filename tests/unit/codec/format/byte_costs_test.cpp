// SPDX-License-Identifier: MIT
#include "core/codec/format/byte_costs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "tests/support/test_motion.h"

namespace mocapress::byte_costs_test {
namespace {

std::vector<std::byte> compressed(const Motion& motion, const EncodeSettings& settings) {
  return write_container(Encoder(motion).encode(settings).compressed);
}

EncodeSettings closed_loop(double error_cm = 0.2) {
  return {.weighting = Weighting::BoneEnds, .target = {Target::Kind::Error, error_cm}};
}

double sum_of(const ByteCosts& costs) {
  return std::accumulate(costs.rest.begin(), costs.rest.end(), costs.bytes.sum(),
                         [](double sum, const ByteCosts::Part& part) { return sum + part.bytes; });
}

double part(const ByteCosts& costs, const std::string& name) {
  for (const ByteCosts::Part& part : costs.rest)
    if (part.name == name) return part.bytes;
  return 0;
}

/// A motion in which one joint alone moves, in one half of the time.
Motion one_joint_in_the_second_half(int joint, int frames) {
  Motion motion = test::smooth_motion(frames);
  const int channel = motion.skeleton.first_channel(joint);
  motion.clip.channels.setZero();
  for (int t = frames / 2; t < frames; ++t)
    motion.clip.channels(t, channel) = 0.4 * std::sin(0.37 * t) + 0.2 * std::sin(1.3 * t);
  return motion;
}

TEST(ByteCosts, AddUpToTheFile) {
  const Motion motion = test::smooth_motion(200);
  for (const int slice : {1, 12, 120, 1000}) {
    const std::vector<std::byte> file = compressed(motion, closed_loop());
    const ByteCosts costs = byte_costs(file, slice);
    EXPECT_EQ(costs.file_bytes, file.size());
    EXPECT_NEAR(sum_of(costs), static_cast<double>(file.size()), 1e-6);
    EXPECT_EQ(costs.bytes.rows(), (200 + slice - 1) / slice);
    EXPECT_GT(costs.bytes.sum(), 0.5 * part(costs, "skeleton"));
    EXPECT_GE(costs.bytes.minCoeff(), 0);
  }
}

// Rounding stays below 8 bytes: else bits of the motion went missing.
TEST(ByteCosts, LeaveOnlyRoundingOutsideOfJoints) {
  for (const double error : {0.02, 0.2, 2.0}) {
    const ByteCosts costs =
        byte_costs(compressed(test::smooth_motion(300), closed_loop(error)), 120);
    EXPECT_GE(part(costs, "scale and rounding"), 0);
    EXPECT_LT(part(costs, "scale and rounding"), 8);
  }
}

TEST(ByteCosts, AreOneSliceForTheLongestSliceThereIs) {
  const std::vector<std::byte> file = compressed(test::smooth_motion(50), closed_loop());
  const ByteCosts costs = byte_costs(file, std::numeric_limits<int>::max());
  EXPECT_EQ(costs.bytes.rows(), 1);
  EXPECT_NEAR(sum_of(costs), static_cast<double>(file.size()), 1e-6);
}

TEST(ByteCosts, FallOnTheJointAndTheTimeThatMove) {
  constexpr int kFrames = 512;
  for (const int joint : {1, 3}) {
    const ByteCosts costs = byte_costs(
        compressed(one_joint_in_the_second_half(joint, kFrames), closed_loop(0.02)), kFrames / 8);
    Eigen::Index most = 0;
    costs.by_joint().maxCoeff(&most);
    EXPECT_EQ(most, joint);
    const Eigen::VectorXd by_slice = costs.by_slice();
    EXPECT_GT(by_slice.tail(4).sum(), 2 * by_slice.head(4).sum());
  }
}

TEST(ByteCosts, AddUpOverSegments) {
  EncodeSettings settings = closed_loop();
  settings.segments = {.longest = 256, .overlap = 16};
  const std::vector<std::byte> file = compressed(test::smooth_motion(700), settings);
  const ByteCosts costs = byte_costs(file, 100);
  EXPECT_NEAR(sum_of(costs), static_cast<double>(file.size()), 1e-6);
  EXPECT_GT(part(costs, "segments"), 0);
  EXPECT_GT(costs.by_slice().minCoeff(), 0);
}

TEST(ByteCosts, FallOnTheEffectorsOfACorrection) {
  const Motion motion = test::smooth_motion(120);
  const int effector = motion.skeleton.joint_count() - 1;
  EncodeSettings settings = closed_loop(0.5);
  const ByteCosts without = byte_costs(compressed(motion, settings), 120);
  settings.correction = EncodeCorrection{.joints = {effector}, .ratio = 4.0};
  const std::vector<std::byte> file = compressed(motion, settings);
  const ByteCosts with = byte_costs(file, 120);
  EXPECT_NEAR(sum_of(with), static_cast<double>(file.size()), 1e-6);
  EXPECT_GT(with.by_joint()(effector), without.by_joint()(effector));
}

TEST(ByteCosts, AreOnePartInWordCodings) {
  const std::vector<std::byte> file =
      compressed(test::smooth_motion(60), {.method = Method::Standard,
                                           .weighting = Weighting::BoneEnds,
                                           .target = {Target::Kind::CoefficientRatio, 4}});
  const ByteCosts costs = byte_costs(file, 10);
  EXPECT_EQ(costs.bytes.sum(), 0);
  EXPECT_GT(part(costs, "motion"), 0);
  EXPECT_NEAR(sum_of(costs), static_cast<double>(file.size()), 1e-6);
}

TEST(ByteCosts, RefuseAFileThatIsCutOff) {
  std::vector<std::byte> file = compressed(test::smooth_motion(60), closed_loop());
  file.pop_back();
  EXPECT_THROW(byte_costs(file, 10), FormatError);
}

}  // namespace
}  // namespace mocapress::byte_costs_test
