// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/clip_outline.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/motion/clip.h"
#include "core/motion/skeleton.h"

namespace mocapress {
namespace {

TEST(ClipOutline, DrawsTheBodyWithoutItsRootOnTheFloor) {
  Motion motion;
  motion.skeleton.add({.name = "root"});
  motion.skeleton.add({.name = "hips",
                       .parent = 0,
                       .offset = {0, 90, 0},
                       .channels = {ChannelKind::TranslationX, ChannelKind::TranslationY}});
  for (const double side : {-1, 1})
    motion.skeleton.add({.name = "leg",
                         .parent = 1,
                         .offset = {10 * side, 0, 0},
                         .end_site = Eigen::Vector3d(0, -80, 0)});
  motion.clip.sample_rate_hz = 30;
  motion.clip.channels = Eigen::RowVector2d(5000, 0);
  const ClipOutline outline = outlineOf(motion, nullptr);
  EXPECT_EQ(outline.bones.size(), 4) << "none from the floor to the hips";
  const auto [low, high] =
      std::minmax_element(outline.bones.begin(), outline.bones.end(),
                          [](const QLineF& a, const QLineF& b) { return a.y2() < b.y2(); });
  EXPECT_GT(high->y2() - low->y2(), 0.9) << "it fills its picture";
}

}  // namespace
}  // namespace mocapress
