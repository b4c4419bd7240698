// SPDX-License-Identifier: MIT
#include "core/report/picture.h"

#include <gtest/gtest.h>

#include "core/formats/bvh.h"

namespace mocapress {
namespace {

/// Below a root on the floor: the hips with two legs, or one chain.
Skeleton below_root(bool branches) {
  const std::string leg =
      "JOINT leg { OFFSET 10 -40 0 CHANNELS 3 Zrotation Xrotation Yrotation "
      "End Site { OFFSET 0 -40 0 } } ";
  std::string other = leg;
  other.replace(other.find("leg"), 3, "arm");
  const std::string text =
      "HIERARCHY ROOT root { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation "
      "Xrotation Yrotation JOINT hips { OFFSET 0 90 0 CHANNELS 3 Zrotation Xrotation Yrotation " +
      leg + (branches ? other : "") + "} } MOTION Frames: 1 Frame Time: 0.01 " +
      (branches ? "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0" : "0 0 0 0 0 0 0 0 0 0 0 0");
  return read_bvh("below_root.bvh", text).motion.skeleton;
}

TEST(FigureShape, HasNoBoneFromARootOnTheFloorToTheHips) {
  for (const DrawnBone& bone : figure_shape(below_root(true))) EXPECT_NE(bone.from, 0);
  EXPECT_EQ(figure_shape(below_root(false)).front().from, 0) << "a chain begins at its root";
}

}  // namespace
}  // namespace mocapress
