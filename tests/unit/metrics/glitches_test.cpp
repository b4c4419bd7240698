// SPDX-License-Identifier: MIT
#include "core/metrics/glitches.h"

#include <gtest/gtest.h>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Eigen::MatrixXd tracks() {
  const Motion motion = test::smooth_motion(200);
  return landmark_tracks(motion.skeleton, motion.clip);
}

TEST(Glitches, AreNoneInASmoothErrorHoweverLarge) {
  const Eigen::MatrixXd original = tracks();
  Eigen::MatrixXd decoded = original;
  for (Eigen::Index t = 0; t < decoded.rows(); ++t)
    decoded.row(t).array() += 10 * std::sin(0.05 * static_cast<double>(t));
  EXPECT_TRUE(find_glitches(original, decoded).empty());
  EXPECT_TRUE(find_glitches(original, original).empty());
}

TEST(Glitches, FindsEachJumpOfOneFrameAndNotItsNeighbours) {
  const Eigen::MatrixXd original = tracks();
  Eigen::MatrixXd decoded = original;
  decoded(50, 3 * 4 + 1) += 2;
  decoded(120, 3 * 1) -= 3;
  const std::vector<Glitch> glitches = find_glitches(original, decoded);
  ASSERT_EQ(glitches.size(), 2u);
  EXPECT_EQ(glitches[0].frame, 50);
  EXPECT_EQ(glitches[0].landmark, 4);
  EXPECT_NEAR(glitches[0].cm, 2, 1e-9);
  EXPECT_EQ(glitches[1].frame, 120);
  EXPECT_EQ(glitches[1].landmark, 1);
}

TEST(Glitches, TakesTheOriginalsOwnJumpsForMotion) {
  Eigen::MatrixXd original = tracks();
  original(70, 8) += 20;
  EXPECT_TRUE(find_glitches(original, original).empty());
  EXPECT_EQ(find_glitches(original, tracks()).size(), 1u);  // smoothed away
}

TEST(Glitches, LeavesOutWhatIsLessThanAskedFor) {
  const Eigen::MatrixXd original = tracks();
  Eigen::MatrixXd decoded = original;
  decoded(50, 0) += 0.4;
  EXPECT_TRUE(find_glitches(original, decoded, 0.5).empty());
  EXPECT_EQ(find_glitches(original, decoded, 0.3).size(), 1u);
}

TEST(Glitches, AreNoneInClipsTooShortToJumpIn) {
  const Eigen::MatrixXd two = tracks().topRows(2);
  EXPECT_TRUE(find_glitches(two, 2 * two).empty());
}

}  // namespace
}  // namespace mocapress
