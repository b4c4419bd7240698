// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/formats/bvh.h"
#include "tests/support/motion_texts.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kMove = 1e-4;  // cm
const ReadOptions kCentimetres{.cm_per_unit = 1.0};

std::vector<std::string> joint_names(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const Joint& joint : skeleton.joints()) names.push_back(joint.name);
  return names;
}

double move_through_bvh(const Motion& motion) {
  const Motion reread = read_bvh("f", bvh_text(motion), kCentimetres).motion;
  return test::largest_move(motion, reread, joint_names(motion.skeleton));
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
            "HIERARCHY\nROOT r\n{\n\tOFFSET 0 0 0\n\tCHANNELS 3 Xposition Yposition Zposition\n"
            "\tJOINT c\n\t{\n\t\tOFFSET 0 70 0\n"
            "\t\tCHANNELS 4 Xposition Yposition Zposition Yrotation\n"
            "\t\tEnd Site\n\t\t{\n\t\t\tOFFSET 0 10 0\n\t\t}\n\t}\n}\n"
            "MOTION\nFrames: 1\nFrame Time: 0.0083333333\n1 105 2 0.25 70 0 0\n");
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

TEST(BvhWriter, MakesOneWordOfAName) {
  Motion motion = test::smooth_motion(1);
  Skeleton renamed;
  for (Joint joint : motion.skeleton.joints()) {
    if (joint.parent < 0) joint.name = "a {b}\n";
    renamed.add(joint);
  }
  motion.skeleton = renamed;
  EXPECT_EQ(read_bvh("f", bvh_text(motion), kCentimetres).motion.skeleton.joint(0).name, "a__b__");
}

}  // namespace
}  // namespace mocapress
