// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/trails.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using testing::ElementsAre;

constexpr int kTrailFrames = 100;
const TrailColours kColours{Qt::blue, Qt::red, Qt::white};

TEST(GhostTrail, TakesAsManyPosesBeforeAsAfterNow) {
  EXPECT_THAT((TrailPoses{50, 10, 2}.frames(kTrailFrames)), ElementsAre(30, 40, 60, 70));
  EXPECT_THAT((TrailPoses{53, 10, 2}.frames(kTrailFrames)), ElementsAre(40, 50, 60, 70));
}

TEST(GhostTrail, StaysInTheClip) {
  EXPECT_THAT((TrailPoses{0, 10, 2}.frames(kTrailFrames)), ElementsAre(10, 20));
  EXPECT_THAT((TrailPoses{kTrailFrames - 1, 10, 2}.frames(kTrailFrames)), ElementsAre(80, 90));
  EXPECT_TRUE((TrailPoses{0, 10, 2}.frames(1).empty()));
}

TEST(GhostTrail, PosesStandStillBetweenTheirMoments) {
  const std::vector<int> at = TrailPoses{41, 10, 3}.frames(kTrailFrames);
  for (int frame = 42; frame < 50; ++frame)
    EXPECT_EQ((TrailPoses{frame, 10, 3}.frames(kTrailFrames)), at) << frame;
}

TEST(GhostTrail, IsThePosesOfThoseFramesFadingWithTheirDistance) {
  const Motion motion = test::smooth_motion(kTrailFrames);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const FigureShape shape(motion.skeleton);
  const TrailPoses poses{50, 10, 3};
  const std::vector<int> frames = poses.frames(kTrailFrames);
  const std::vector<Capsule> trail = ghostTrail(shape, tracks, poses, kColours);
  const auto each = static_cast<std::size_t>(shape.partCount());
  ASSERT_EQ(trail.size(), frames.size() * each);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(trail[i * each].start,
              landmarkAt(tracks, frames[i], motion.skeleton.segments().front().joint));
    const QVector4D tint = trail[i * each].start_tint;
    // Past poses are blue, future ones red, and both fade with distance.
    EXPECT_EQ(tint.z() > tint.x(), frames[i] < 50);
    EXPECT_NEAR(tint.y(), std::abs(frames[i] - 50) / 40.0, 0.01);
  }
}

}  // namespace
}  // namespace mocapress
