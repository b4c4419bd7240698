// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <numbers>

#include "core/formats/amc.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/motion_texts.h"

namespace mocapress::amc_reader_test {
namespace {

using test::kSmallAmc;
using test::kSmallAsf;
using test::replaced;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kCm = 2.54 / 0.45;
constexpr double kRounding = 1e-9;

MotionFile read(const std::string& amc, const std::string& asf = kSmallAsf) {
  return read_amc("f.amc", amc, read_asf("f.asf", asf));
}

std::string error_of(const std::string& amc, const std::string& asf = kSmallAsf) {
  try {
    read(amc, asf);
  } catch (const InputError& error) {
    return error.what();
  }
  return "reads";
}

std::string warning_of(const std::string& amc, const std::string& asf = kSmallAsf) {
  const Warnings warnings = read(amc, asf).warnings;
  return warnings.size() == 1 ? warnings.front().text() : std::to_string(warnings.size());
}

std::vector<std::string> channel_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (int c = 0; c < skeleton.channel_count(); ++c) names.push_back(skeleton.channel_name(c));
  return names;
}

TEST(Amc, ReadsASmallFileWithItsBonesInAnyOrder) {
  const auto [motion, warnings, source, states_rate, skin, takes, tracks] = read(kSmallAmc);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(channel_names(motion.skeleton),
            (std::vector<std::string>{"root.tx", "root.ty", "root.tz", "root.rz", "root.ry",
                                      "root.rx", "thigh.rz", "thigh.ry", "thigh.rx", "shin.rx"}));
  EXPECT_EQ(motion.clip.sample_rate_hz, 120);
  ASSERT_EQ(motion.clip.frames(), 3);
  Eigen::RowVectorXd last(10);
  last << 3 * kCm, 2 * kCm, 3 * kCm, 30 * kDegree, 20 * kDegree, 10 * kDegree, 62 * kDegree,
      52 * kDegree, 42 * kDegree, 72 * kDegree;
  EXPECT_TRUE(motion.clip.channels.row(2).isApprox(last, kRounding));
}

// Computed by hand, with quarter turns. C = Rz(90) takes the shin's x to y: its "rx" turns about
// the world's y.
TEST(Amc, PosesBonesByTheirAxes) {
  const std::string asf =
      replaced(replaced(kSmallAsf, "axis 0 0 20", "axis 0 0 90"), "length 0.45", "length 2.54");
  const Motion motion =
      read("1\nroot 1 2 3 0 0 0\nthigh 0 0 90\nshin 90\n", replaced(asf, "0 -1 0", "1 0 0")).motion;
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), pose);
  // thigh: Rz(90) takes (7, 0, 0) to (0, 7, 0); C does not matter, as it turns about z too.
  EXPECT_NEAR((pose.origin[2] - Eigen::Vector3d(1, 9, 3)).norm(), 0, kRounding);
  // shin: Ry(90) takes (8, 0, 0) to (0, 0, -8), which the thigh's Rz(90) leaves alone.
  const Eigen::Vector3d end = pose.to_world(2, *motion.skeleton.joint(2).end_site);
  EXPECT_NEAR((end - Eigen::Vector3d(1, 9, -5)).norm(), 0, kRounding);
}

TEST(Amc, TurnsTheRootAboutXThenYThenZ) {
  const std::string asf = replaced(kSmallAsf, "length 0.45", "length 2.54");
  const Motion motion = read("1\nroot 0 0 0 90 90 0\nthigh 0 0 0\nshin 0\n", asf).motion;
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), pose);
  // (0, -7, 0): Rx(90) -> (0, 0, -7), Ry(90) -> (-7, 0, 0).
  EXPECT_NEAR((pose.origin[2] - Eigen::Vector3d(-7, 0, 0)).norm(), 0, kRounding);
}

TEST(Amc, ReadsRadiansAndARate) {
  const std::string header = ":RADIANS\n:SAMPLES-PER-SECOND 60\n:UNHEARD-OF\n";
  const MotionFile file = read(header + "1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshin 0.5\n");
  EXPECT_EQ(file.motion.clip.channels(0, 9), 0.5);
  EXPECT_EQ(file.motion.clip.sample_rate_hz, 60);
  EXPECT_TRUE(file.states_rate);
  EXPECT_FALSE(read(kSmallAmc).states_rate);
  const AsfSkeleton skeleton = read_asf("f.asf", kSmallAsf);
  EXPECT_EQ(read_amc("f", kSmallAmc, skeleton, {.sample_rate_hz = 30.0, .cm_per_unit = {}})
                .motion.clip.sample_rate_hz,
            30);
}

TEST(Amc, UnwrapsAngles) {
  const Motion motion =
      read(replaced(replaced(kSmallAmc, "shin 71", "shin 179"), "shin 72", "shin -179")).motion;
  EXPECT_NEAR(motion.clip.channels(2, 9), 181 * kDegree, kRounding);
}

TEST(Amc, DropsALastFrameCutAnywhere) {
  const std::size_t third = kSmallAmc.find("3\nshin");
  for (std::size_t size = third + 1; size < kSmallAmc.size() - 3; ++size) {
    const auto [motion, warnings, source, states_rate, skin, takes, tracks] =
        read(kSmallAmc.substr(0, size));
    EXPECT_EQ(motion.clip.frames(), 2) << kSmallAmc.substr(third, size - third);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].text(),
              "f.amc:12: the file ends within its last frame, which is dropped");
  }
}

TEST(Amc, WarnsOfFrameNumbersThatJump) {
  for (const std::string& text :
       {replaced(kSmallAmc, "2\nroot", "7\nroot"), replaced(kSmallAmc, "1\nroot", "0\nroot")}) {
    EXPECT_EQ(read(text).motion.clip.frames(), 3);
    EXPECT_NE(warning_of(text).find("frame numbers do not run"), std::string::npos);
  }
}

TEST(Amc, RepeatsTheFrameBeforeForAMissingBone) {
  const std::string text = replaced(kSmallAmc, "shin 71\n", "");
  EXPECT_NEAR(read(text).motion.clip.channels(1, 9), 70 * kDegree, kRounding);
  EXPECT_EQ(warning_of(text),
            "f.amc: 1 bone missing from a frame, where the frame before is repeated");
}

TEST(Amc, RepairsValuesThatAreNoNumbers) {
  const std::string text = replaced(kSmallAmc, "root 2 2 3", "root nan -inf 1.#QNAN");
  const Motion motion = read(text).motion;
  EXPECT_EQ(motion.clip.channels.row(1).head<3>(), motion.clip.channels.row(0).head<3>());
  EXPECT_EQ(warning_of(text),
            "f.amc: 3 values not finite or beyond 1e9, replaced by the frame before");
}

TEST(Amc, LeavesBonesWithoutValuesAtRestAndWithoutChannels) {
  const std::string text = "1\nroot 0 0 0 0 0 0\nshin 5\n2\nroot 0 0 0 0 0 0\nshin 6\n";
  EXPECT_EQ(read(text).motion.skeleton.channel_count(), 7);
  EXPECT_EQ(warning_of(text), "f.amc: 1 bone with dof but without values, left at rest");
}

TEST(Amc, ReadsThreeValuesOnABoneWithFewerDofAsRxRyRz) {
  const std::string text = "1\nroot 0 0 0 0 0 0\nthigh 1 2 3\nshin 4 5 6\narm 7 8 9\n";
  const Motion motion = read(text).motion;
  EXPECT_EQ(motion.skeleton.channel_count(), 15);
  EXPECT_EQ(motion.skeleton.channel_name(9), "shin.rz");
  EXPECT_NEAR(motion.clip.channels(0, 9), 6 * kDegree, kRounding);
  EXPECT_NEAR(motion.clip.channels(0, 14), 7 * kDegree, kRounding);
  EXPECT_NE(warning_of(text).find("2 bones with three values"), std::string::npos);
}

TEST(Amc, PutsTheDofFirstWhere3DofAreForced) {
  const std::string text =
      ":FORCE-ALL-JOINTS-BE-3DOF\n1\nroot 0 0 0 0 0 0\nthigh 1 2 3\nshin 4 5 6\n";
  const Motion motion = read(text, replaced(kSmallAsf, "dof rx\n", "dof ry\n")).motion;
  EXPECT_EQ(motion.skeleton.channel_name(9), "shin.rz");
  EXPECT_NEAR(motion.clip.channels(0, 9), 6 * kDegree, kRounding);
  EXPECT_NEAR(motion.clip.channels(0, 10), 4 * kDegree, kRounding);
  EXPECT_NEAR(motion.clip.channels(0, 11), 5 * kDegree, kRounding);
}

TEST(Amc, IgnoresBoneLengthsWithAWarning) {
  const std::string asf = replaced(kSmallAsf, "dof rx\n", "dof rx l\n");
  const std::string text = "1\nroot 0 0 0 0 0 0\nthigh 1 2 3\nshin 4 0.5\n";
  EXPECT_NEAR(read(text, asf).motion.clip.channels(0, 9), 4 * kDegree, kRounding);
  EXPECT_EQ(warning_of(text, asf),
            "f.amc: 1 bone with a length that changes (dof l), which is ignored");
}

TEST(Amc, RefusesAFigureOfWhichOnlyLengthsChange) {
  EXPECT_EQ(error_of("1\nroot 0\n", ":name f\n:root\norder l\n"),
            "f.amc:3:1: no bone has a value: nothing moves");
}

TEST(Amc, MovesABoneAlongItsAxes) {
  std::string asf = replaced(kSmallAsf, "dof rx\n", "dof tx rx\n");
  asf = replaced(replaced(asf, "axis 0 0 20", "axis 0 0 90"), "length 0.45", "length 2.54");
  const Motion motion = read("1\nroot 0 0 0 0 0 0\nthigh 0 0 0\nshin 2 0\n", asf).motion;
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(0), pose);
  EXPECT_NEAR((pose.origin[2] - Eigen::Vector3d(0, -7 + 2, 0)).norm(), 0, kRounding);
}

TEST(Amc, RefusesWhatItCannotPlace) {
  EXPECT_EQ(error_of(""), "f.amc:1:1: expected a complete frame, found none");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "shin 71", "tail 71")),
            "f.amc:11:1: expected a bone of f.asf, found 'tail'");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "shin 71", "shin 0x47")),
            "f.amc:11:6: expected a number, found '0x47'");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "thigh 41 51 61", "thigh 41 51")),
            "f.amc:10:1: expected 3 values for 'thigh', found 2");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "shin 70", "shin 70 71")),
            "f.amc:7:1: expected 1 values for 'shin', found 2");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "shin 71", "root 2 2 3 10 20 30")),
            "f.amc:11:1: 'root' twice in one frame");
  EXPECT_EQ(error_of(replaced(kSmallAmc, "1\nroot", "root")),
            "f.amc:4:1: expected a frame number, found 'root'");
  EXPECT_EQ(error_of("1\nroot 0 0 0 0 0 0\nthigh 1 2"),
            "f.amc:3:10: the file ends within its first frame");
}

TEST(Amc, RefusesFramesThatAreMostlyEmptyBeforeTheyTakeMemory) {
  std::string text = kSmallAmc;
  for (int t = 4; t < 1000; ++t) text += std::to_string(t) + "\n";
  EXPECT_EQ(error_of(text), "f.amc:16:1: frame '4' has only 0 bones");
}

}  // namespace
}  // namespace mocapress::amc_reader_test
