// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure_shape.h"

#include <gtest/gtest.h>

#include <optional>

#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Joint joint(int parent, const Eigen::Vector3d& offset,
            const std::optional<Eigen::Vector3d>& end_site = {}) {
  Joint joint;
  joint.parent = parent;
  joint.offset = offset;
  joint.end_site = end_site;
  return joint;
}

std::vector<Capsule> posed(const FigureShape& shape, const Eigen::MatrixXd& tracks, int frame,
                           int selected_joint) {
  std::vector<Capsule> capsules(static_cast<std::size_t>(shape.capsuleCount()));
  shape.pose(tracks, frame, {selected_joint, {}, {}}, capsules);
  return capsules;
}

TEST(FigureShape, LaysACapsuleAlongEverySegmentAndABallOnEveryJoint) {
  const Motion motion = test::smooth_motion(4);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const FigureShape shape(motion.skeleton);
  const std::vector<Segment> segments = motion.skeleton.segments();
  const auto joints = static_cast<std::size_t>(motion.skeleton.joint_count());
  const std::vector<Capsule> capsules = posed(shape, tracks, 3, -1);

  ASSERT_EQ(capsules.size(), joints + segments.size());
  for (std::size_t j = 0; j < joints; ++j) {
    EXPECT_EQ(capsules[j].start, landmarkAt(tracks, 3, static_cast<int>(j)));
    EXPECT_EQ(capsules[j].start, capsules[j].end);
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Capsule& bone = capsules[joints + s];
    EXPECT_EQ(bone.start, landmarkAt(tracks, 3, segments[s].joint));
    EXPECT_NEAR((bone.end - bone.start).length(), segments[s].length, 1e-3);
    EXPECT_GT(bone.start_radius, bone.end_radius);
    EXPECT_GT(bone.end_radius, 0);
  }
}

TEST(FigureShape, HighlightsTheSelectedJointAlone) {
  const Motion motion = test::smooth_motion(1);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const std::vector<Capsule> capsules = posed(FigureShape(motion.skeleton), tracks, 0, 2);
  for (std::size_t c = 0; c < capsules.size(); ++c)
    EXPECT_EQ(capsules[c].highlight, c == 2 ? 1 : 0) << c;
}

TEST(FigureShape, DrawsNoBoneWithoutLength) {
  Skeleton skeleton;
  skeleton.add(joint(-1, {0, 0, 0}));
  skeleton.add(joint(0, {0, 0, 0}));
  skeleton.add(joint(1, {0, 10, 0}));
  EXPECT_EQ(FigureShape(skeleton).capsuleCount(), 3 + 1);
}

TEST(FigureShape, KeepsItsProportionsAtAnySize) {
  for (const double size : {0.1, 1000.0}) {
    Skeleton skeleton;
    skeleton.add(joint(-1, {0, 0, 0}, Eigen::Vector3d(0, size, 0)));
    const Eigen::MatrixXd tracks = landmark_tracks(skeleton, {.channels = Eigen::MatrixXd(1, 0)});
    const FigureShape shape(skeleton);
    EXPECT_NEAR(shape.size() / size, 1, 1e-5);
    EXPECT_NEAR(posed(shape, tracks, 0, -1)[1].start_radius / size, 0.034, 1e-5);
  }
}

TEST(FigureShape, ShowsALonePointAndNoPoint) {
  Skeleton point;
  point.add(joint(-1, {0, 0, 0}));
  EXPECT_GT(FigureShape(point).size(), 0);
  EXPECT_EQ(FigureShape(point).capsuleCount(), 1);
  EXPECT_EQ(FigureShape(Skeleton()).capsuleCount(), 0);
}

TEST(FigureShape, CentresOnTheBoxAroundAllLandmarks) {
  Eigen::MatrixXd tracks(1, 9);
  tracks << 0, 0, 0, 10, 2, 4, 1, 1, -8;
  Skeleton three;
  for (const int parent : {-1, 0, 0}) three.add(joint(parent, {0, 0, 0}));
  EXPECT_EQ(FigureShape(three).centre(tracks, 0), QVector3D(5, 1, -2));
}

TEST(FigureShape, TheBodyBeginsWhereSomethingWalksAwayFromTheFloor) {
  Skeleton game;
  game.add(joint(-1, {0, 0, 0}));
  Joint hips = joint(0, {0, 90, 0});
  hips.channels = {ChannelKind::TranslationX, ChannelKind::TranslationY};
  game.add(hips);
  game.add(joint(1, {0, 60, 0}));
  game.add(joint(1, {10, -80, 0}));
  const FigureShape shape(game);
  EXPECT_EQ(shape.bodyRoot(), 1);
  Clip clip;
  clip.channels = Eigen::RowVector2d(900, 0);
  const Eigen::MatrixXd tracks = landmark_tracks(game, clip);
  EXPECT_GT(shape.centre(tracks, 0).x(), 850);
  EXPECT_EQ(shape.body(tracks, 0).size(), 3u);

  EXPECT_EQ(FigureShape(test::small_skeleton()).bodyRoot(), 0);
}

}  // namespace
}  // namespace mocapress
