// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/formats/amc.h"
#include "tests/support/motion_texts.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress::asf_writer_test {
namespace {

constexpr double kMove = 1e-4;  // cm

Motion through_acclaim(const Motion& motion) {
  const Motion acclaim = acclaim_motion(motion);
  const AsfSkeleton skeleton = read_asf("f.asf", asf_text(acclaim.skeleton));
  return read_amc("f.amc", amc_text(acclaim), skeleton).motion;
}

TEST(AcclaimWriter, MovesNoPoint) {
  const Motion motion = test::smooth_motion(40);
  EXPECT_LT(test::largest_move(motion, through_acclaim(motion), asf_names(motion.skeleton)), kMove);
}

TEST(AcclaimWriter, KeepsRateChannelsAndJointsOfWhatCameFromAcclaim) {
  const AsfSkeleton skeleton = read_asf("f.asf", test::kSmallAsf);
  Motion motion = read_amc("f.amc", test::kSmallAmc, skeleton).motion;
  motion.clip.sample_rate_hz = 60;
  const Motion reread = through_acclaim(motion);
  EXPECT_EQ(reread.clip.sample_rate_hz, 60);
  ASSERT_EQ(reread.skeleton.joint_count(), motion.skeleton.joint_count());
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    EXPECT_EQ(reread.skeleton.channel_name(c), motion.skeleton.channel_name(c));
  EXPECT_TRUE(reread.clip.channels.isApprox(motion.clip.channels, 1e-6));
}

TEST(AcclaimWriter, CarriesChildrenToTheirPlacesWithBonesWithoutDof) {
  Motion motion;
  motion.skeleton.add({.name = "Hips", .channels = {ChannelKind::RotationX}});
  motion.skeleton.add({.name = "chest",
                       .parent = 0,
                       .offset = {0, 20, 0},
                       .channels = {ChannelKind::RotationZ, ChannelKind::RotationX}});
  for (const double side : {-1.0, 1.0})
    motion.skeleton.add({.name = side < 0 ? "left" : "right",
                         .parent = 1,
                         .offset = {10 * side, 30, 0},
                         .channels = {ChannelKind::RotationY},
                         .end_site = Eigen::Vector3d(0, 0, 60)});
  motion.clip.channels = Eigen::MatrixXd::Constant(3, 5, 0.5);
  const Motion reread = through_acclaim(motion);
  EXPECT_EQ(reread.skeleton.joint_count(), 4 + 2);
  EXPECT_GE(reread.skeleton.find("to_chest"), 0);
  EXPECT_GE(reread.skeleton.find("to_right"), 0);
  EXPECT_EQ(reread.skeleton.channel_count(), 5);
  EXPECT_LT(test::largest_move(motion, reread, asf_names(motion.skeleton)), kMove);
}

TEST(AcclaimWriter, TurnsATurnedRootAndTurnedMovingBonesStraight) {
  Motion motion = test::smooth_motion(10);
  Skeleton turned;
  for (Joint joint : motion.skeleton.joints()) {
    joint.joint_from_axes = axis_rotation(1, 0.5) * axis_rotation(0, 0.3);
    turned.add(joint);
  }
  motion.skeleton = turned;
  EXPECT_LT(test::largest_move(motion, through_acclaim(motion), asf_names(motion.skeleton)), kMove);
}

TEST(AcclaimWriter, GivesEveryJointAWordOfItsOwn) {
  Skeleton skeleton;
  skeleton.add({.name = "Hips"});
  for (const char* name : {"root", "arm", "arm", "left arm", "12", "end", "#1", ":x", ""})
    skeleton.add({.name = name, .parent = 0});
  EXPECT_EQ(asf_names(skeleton),
            (std::vector<std::string>{"root", "root_2", "arm", "arm_2", "left_arm", "_12", "_end",
                                      "_#1", "_:x", "_"}));
}

TEST(AcclaimWriter, RefusesSeveralRoots) {
  Skeleton skeleton;
  skeleton.add({.name = "a"});
  skeleton.add({.name = "b"});
  EXPECT_THROW(asf_text(skeleton), Error);
}

TEST(AcclaimWriter, RefusesWhatNoReaderHereWouldTake) {
  // Each joint needs a bone that leads to its place.
  Skeleton star;
  star.add({.name = "root"});
  while (star.joint_count() < 3000)
    star.add({.name = "j", .parent = 0, .offset = Eigen::Vector3d(1, star.joint_count(), 0)});
  EXPECT_THROW(asf_text(star), Error);
  Skeleton chain;
  for (int j = 0; j < 1001; ++j)
    chain.add({.name = "j", .parent = j - 1, .offset = Eigen::Vector3d(0, 1, 0)});
  EXPECT_THROW(asf_text(chain), Error);
}

TEST(AsfWriter, RefusesTwoFiguresInASentence) {
  Skeleton two;
  two.add({.name = "a", .channels = {ChannelKind::RotationX}});
  two.add({.name = "b", .parent = -1, .offset = {100, 0, 0}});
  try {
    asf_text(two);
    FAIL();
  } catch (const WriteError& error) {
    EXPECT_STREQ(error.what(),
                 "an .amc holds one figure with one root, but this clip has 2 roots: .bvh and .glb "
                 "can hold it");
  }
}

}  // namespace
}  // namespace mocapress::asf_writer_test
