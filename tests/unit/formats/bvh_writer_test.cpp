// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <sstream>

#include "core/formats/bvh.h"
#include "tests/support/motion_texts.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress::bvh_writer_test {
namespace {

constexpr double kMove = 1e-4;  // cm
const ReadOptions kCentimetres{.cm_per_unit = 1.0};

double move_through_bvh(const Motion& motion) {
  const Motion reread = read_bvh("f", bvh_text(motion), kCentimetres).motion;
  return test::largest_move(motion, reread, bvh_names(motion.skeleton));
}

/// The lines of a text that begin with `word`, ignoring leading spaces.
std::vector<std::string> lines_with(const std::string& text, const std::string& word) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.starts_with(word)) found.push_back(line);
  }
  return found;
}

/// The small file with a root that stands 5 and 7 above its OFFSET or above zero.
Motion root_above_its_offset() {
  return read_bvh("f", test::kSmallBvh, kCentimetres).motion;
}

TEST(BvhWriter, MovesNoPoint) {
  EXPECT_LT(move_through_bvh(test::smooth_motion(40)), kMove);
}

TEST(BvhWriter, KeepsTheRate) {
  for (const double rate : {24.0, 59.94, 120.0, 1000.0}) {
    Motion motion = test::smooth_motion(2);
    motion.clip.sample_rate_hz = rate;
    EXPECT_NEAR(read_bvh("f", bvh_text(motion), kCentimetres).motion.clip.sample_rate_hz, rate,
                1e-4 * rate);
  }
}

TEST(BvhWriter, PutsTheRootAtZeroAndMovingJointsAtAbsolutePositions) {
  Motion motion;
  Joint root{.name = "r", .offset = {1, 100, 2}, .channels = {ChannelKind::TranslationY}};
  motion.skeleton.add(root);
  Joint child{.name = "c",
              .parent = 0,
              .offset = {0, 70, 0},
              .channels = {ChannelKind::TranslationX, ChannelKind::RotationY},
              .end_site = Eigen::Vector3d(0, 10, 0)};
  motion.skeleton.add(child);
  motion.clip.channels.resize(1, 3);
  motion.clip.channels << 5, 0.25, 0;
  EXPECT_EQ(bvh_text(motion),
            "HIERARCHY\nROOT r\n{\n\tOFFSET 0 0 0\n"
            "\tCHANNELS 6 Xposition Yposition Zposition Zrotation Yrotation Xrotation\n"
            "\tJOINT c\n\t{\n\t\tOFFSET 0 70 0\n"
            "\t\tCHANNELS 6 Xposition Yposition Zposition Yrotation Zrotation Xrotation\n"
            "\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 10 0\n\t\t}\n\t}\n}\n"
            "MOTION\nFrames: 1\nFrame Time: 0.0083333333\n1 105 2 0 0 0 0.25 70 0 0 0 0\n");
  EXPECT_LT(move_through_bvh(motion), kMove);
}

TEST(BvhWriter, NestsChildrenThatDoNotFollowTheirParent) {
  Motion motion;
  motion.skeleton.add({.name = "root", .channels = {ChannelKind::RotationX}});
  for (const auto& [name, parent] : std::vector<std::pair<std::string, int>>{
           {"a", 0}, {"b", 0}, {"a1", 1}, {"b1", 2}, {"a11", 3}})
    motion.skeleton.add({.name = name,
                         .parent = parent,
                         .offset = {1, 20, static_cast<double>(parent)},
                         .channels = {ChannelKind::RotationZ}});
  motion.clip.channels = Eigen::MatrixXd::NullaryExpr(
      5, 6, [](Eigen::Index t, Eigen::Index c) { return 0.1 * static_cast<double>(t - 2 * c); });
  EXPECT_LT(move_through_bvh(motion), kMove);
}

TEST(BvhWriter, GivesEveryJointThreeRotationsThatAreZeroWhereItHasNone) {
  using enum ChannelKind;
  Motion motion;
  const std::vector<std::vector<ChannelKind>> channels = {
      {TranslationX, RotationY}, {}, {RotationX}, {RotationY, RotationX}, {RotationX, RotationZ}};
  for (int j = 0; j < 5; ++j)
    motion.skeleton.add({.name = std::string(1, static_cast<char>('a' + j)),
                         .parent = j - 1,
                         .offset = {1, 20, 3},
                         .channels = channels[static_cast<std::size_t>(j)]});
  motion.clip.channels = Eigen::MatrixXd::NullaryExpr(
      4, 7, [](Eigen::Index t, Eigen::Index c) { return 0.2 * static_cast<double>(t - c); });
  const std::string text = bvh_text(motion);
  EXPECT_EQ(
      lines_with(text, "CHANNELS"),
      (std::vector<std::string>{
          "CHANNELS 6 Xposition Yposition Zposition Yrotation Zrotation Xrotation",
          "CHANNELS 3 Zrotation Yrotation Xrotation", "CHANNELS 3 Xrotation Zrotation Yrotation",
          "CHANNELS 3 Yrotation Xrotation Zrotation", "CHANNELS 3 Xrotation Zrotation Yrotation"}));
  EXPECT_LT(move_through_bvh(motion), kMove);
}

TEST(BvhWriter, WritesRotationsAboutOneAxisTwiceInAnOrderThatFilesCanHave) {
  using enum ChannelKind;
  Motion motion;
  motion.skeleton.add({.name = "a",
                       .channels = {RotationZ, RotationX, RotationZ},
                       .end_site = Eigen::Vector3d(10, 20, 30)});
  motion.clip.channels = Eigen::MatrixXd::NullaryExpr(
      9, 3, [](Eigen::Index t, Eigen::Index c) { return 0.1 * static_cast<double>(t + 2 * c); });
  EXPECT_EQ(lines_with(bvh_text(motion), "CHANNELS").front(),
            "CHANNELS 3 Zrotation Yrotation Xrotation");
  EXPECT_LT(move_through_bvh(motion), kMove);
}

TEST(BvhWriter, GivesEveryJointAWordOfItsOwnThatNoReaderTakesForAnother) {
  Skeleton skeleton;
  skeleton.add({.name = "a {b}\n"});
  for (const char* name :
       {"left arm", "left arm", "left_arm_2", "", "End", "joint", "a\"b\\c'", "mixamorig:Hips",
        "\u5de6\u8155", "a\u3000b", "caf\xe9", "\xed\xa0\x80", "x\xf0\x9f"})
    skeleton.add({.name = name, .parent = 0});
  EXPECT_EQ(bvh_names(skeleton),
            (std::vector<std::string>{"a__b__", "left_arm", "left_arm_2", "left_arm_2_2", "_",
                                      "_End", "_joint", "a_b_c_", "mixamorig:Hips", "\u5de6\u8155",
                                      "a___b", "caf_", "___", "x__"}));
}

TEST(BvhWriter, GivesBackRoundOffsetsThatWereKeptAsFloats) {
  for (const double cm : {1.0, 2.54, 2.54 / 0.45, 100.0}) {
    Motion motion = root_above_its_offset();
    Skeleton kept;
    for (Joint joint : motion.skeleton.joints()) {
      joint.offset = (cm * Eigen::Vector3d(0.12345, 13.1, -7.77)).cast<float>().cast<double>();
      kept.add(joint);
    }
    motion.skeleton = kept;
    EXPECT_EQ(lines_with(bvh_text(motion, {.cm_per_unit = cm}), "OFFSET")[1],
              "OFFSET 0.12345 13.1 -7.77");
  }
}

TEST(BvhWriter, WritesInTheUnitOfItsSource) {
  const Motion motion = test::smooth_motion(20);
  for (const double cm : {2.54, 100.0, 0.1, 2.54 / 0.45}) {
    const BvhStyle style{.cm_per_unit = cm};
    const MotionFile reread =
        read_bvh("f", bvh_text(motion, style), {.sample_rate_hz = {}, .cm_per_unit = cm});
    EXPECT_LT(test::largest_move(motion, reread.motion, bvh_names(motion.skeleton)), kMove) << cm;
    EXPECT_EQ(reread.source.cm_per_unit, cm);
  }
}

TEST(BvhWriter, KeepsTheOffsetOfARootThatReplacedIt) {
  const Motion motion = root_above_its_offset();
  const BvhStyle replacing =
      bvh_style({.kind = SourceFormat::Kind::Bvh, .root = TranslationConvention::Replaces});
  const std::string text = bvh_text(motion, replacing);
  EXPECT_EQ(lines_with(text, "OFFSET").front(), "OFFSET 0 90 0");
  EXPECT_EQ(lines_with(text, "1 ").front().substr(0, 7), "1 92 3 ");
  EXPECT_LT(test::largest_move(motion, read_bvh("f", text).motion, {"Hips", "Spine"}), kMove);
}

TEST(BvhWriter, PutsARootThatAddedToItsOffsetWhereEveryReaderFindsIt) {
  const Motion motion = root_above_its_offset();
  const SourceFormat adding{.kind = SourceFormat::Kind::Bvh, .root = TranslationConvention::Adds};
  const std::string text = bvh_text(motion, bvh_style(adding));
  EXPECT_EQ(lines_with(text, "OFFSET").front(), "OFFSET 0 0 0");
  for (const auto convention : {TranslationConvention::Adds, TranslationConvention::Replaces})
    EXPECT_LT(test::largest_move(motion, read_bvh("f", text, {.bvh_root = convention}).motion,
                                 {"Hips", "Spine"}),
              kMove);
}

TEST(BvhWriter, WritesARootThatAddsWhereThatIsAskedFor) {
  const Motion motion = root_above_its_offset();
  const std::string text =
      bvh_text(motion, bvh_style({}, {.bvh_root = TranslationConvention::Adds}));
  EXPECT_EQ(lines_with(text, "OFFSET").front(), "OFFSET 0 90 0");
  EXPECT_EQ(lines_with(text, "1 ").front().substr(0, 6), "1 2 3 ");
  EXPECT_LT(test::largest_move(motion, read_bvh("f", text).motion, {"Hips", "Spine"}), kMove);
}

TEST(BvhStyle, TakesTheUnitOfBvhSourcesAlone) {
  EXPECT_EQ(bvh_style({.kind = SourceFormat::Kind::Bvh, .cm_per_unit = 2.54}).cm_per_unit, 2.54);
  EXPECT_EQ(bvh_style({.kind = SourceFormat::Kind::Acclaim, .cm_per_unit = 2.54}).cm_per_unit, 1);
  EXPECT_EQ(bvh_style({.kind = SourceFormat::Kind::Bvh, .cm_per_unit = 2.54},
                      {.sample_rate_hz = {}, .cm_per_unit = 100.0})
                .cm_per_unit,
            100);
}

/// Readers take anything after "#" for a comment.
TEST(BvhWriter, LetsNoNameBeAComment) {
  Motion motion;
  motion.skeleton.add({.name = "#1", .channels = {ChannelKind::RotationX}});
  motion.clip.channels = Eigen::MatrixXd::Zero(1, 1);
  EXPECT_EQ(bvh_names(motion.skeleton).front(), "_#1");
  EXPECT_EQ(read_bvh("f", bvh_text(motion)).motion.skeleton.joint(0).name, "_#1");
}

}  // namespace
}  // namespace mocapress::bvh_writer_test
