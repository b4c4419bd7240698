// SPDX-License-Identifier: MIT
#include "core/report/picture.h"

#include <gtest/gtest.h>

#include <string>

#include "core/formats/bvh.h"

namespace mocapress {
namespace {

/// Hips with one leg, 90 cm above their root: they move away from it, or are turned alone.
Skeleton above_root(bool moved) {
  const std::string turned = "Zrotation Xrotation Yrotation";
  const std::string text =
      "HIERARCHY ROOT root { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition " + turned +
      " JOINT hips { OFFSET 0 90 0 CHANNELS " +
      (moved ? "6 Xposition Yposition Zposition " : "3 ") + turned +
      " JOINT leg { OFFSET 10 -40 0 CHANNELS 3 " + turned +
      " End Site { OFFSET 0 -40 0 } } } } MOTION Frames: 1 Frame Time: 0.01 " +
      (moved ? "0 0 0 0 0 0 0 90 0 0 0 0 0 0 0" : "0 0 0 0 0 0 0 0 0 0 0 0");
  return read_bvh("above_root.bvh", text).motion.skeleton;
}

TEST(FigureShape, HasNoBoneFromARootOnTheFloorToTheHipsThatMoveAwayFromIt) {
  const std::vector<DrawnBone> body = figure_shape(above_root(true));
  ASSERT_FALSE(body.empty());
  for (const DrawnBone& bone : body) EXPECT_NE(bone.from, 0);
  EXPECT_EQ(figure_shape(above_root(false)).front().from, 0) << "that one is part of the body";
}

TEST(FigureShape, AHeadWithoutATopIsDrawnAroundItsJoint) {
  const Skeleton skeleton =
      read_bvh("neck.bvh",
               "HIERARCHY ROOT neck { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation JOINT "
               "Head { OFFSET 0 8 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 0 "
               "0 } } } MOTION Frames: 1 Frame Time: 0.01 0 0 0 0 0 0")
          .motion.skeleton;
  const std::vector<DrawnBone> body = figure_shape(skeleton);
  ASSERT_EQ(body.size(), 1u);
  EXPECT_EQ(body[0].to, skeleton.find("Head"));
  EXPECT_GT(body[0].to_radius, body[0].from_radius) << "a neck gets thinner";
}

}  // namespace
}  // namespace mocapress
