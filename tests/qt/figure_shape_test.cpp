// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure_shape.h"

#include <gtest/gtest.h>

#include <numbers>
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

std::vector<Capsule> posed(const FigureShape& shape, const Eigen::MatrixXd& tracks, int frame) {
  return shape.posed(tracks, frame, {});
}

/// A human of 180 cm with arms down, without ends of hands and head. `floor`: the root stays on the
/// ground, as in games.
Skeleton human(bool floor) {
  Skeleton skeleton;
  const auto add = [&](const std::string& name, int parent, double x, double y, double z) {
    Joint each = joint(parent, {x, y, z});
    each.name = name;
    if (name == "Hips") each.channels = {ChannelKind::TranslationX, ChannelKind::TranslationY};
    return skeleton.add(each);
  };
  const int root = floor ? add("root", -1, 0, 0, 0) : -1;
  const int hips = add("Hips", root, 0, 95, 0);
  const int spine = add("Spine", hips, 0, 12, 0);
  const int chest = add("Chest", spine, 0, 25, 0);
  const int neck = add("Neck", chest, 0, 16, 0);
  add("Head", neck, 0, 10, 2);
  for (const double side : {1.0, -1.0}) {
    const std::string name = side > 0 ? "Left" : "Right";
    const int collar = add(name + "Shoulder", chest, 4 * side, 12, 0);
    const int arm = add(name + "Arm", collar, 14 * side, 0, 0);
    const int forearm = add(name + "ForeArm", arm, 0, -30, 0);
    add(name + "Hand", forearm, 0, -26, 0);
    const int thigh = add(name + "UpLeg", hips, 9 * side, -4, 0);
    const int shin = add(name + "Leg", thigh, 0, -43, 0);
    const int foot = add(name + "Foot", shin, 0, -41, 0);
    add(name + "ToeBase", foot, 0, -6, 14);
  }
  return skeleton;
}

/// The distance (cm) of a point from the nearest capsule's surface; negative inside.
double outside(const std::vector<Capsule>& capsules, const QVector3D& point) {
  double nearest = 1e9;
  for (const Capsule& each : capsules) {
    const QVector3D span = each.end - each.start;
    const float length = span.lengthSquared();
    const float along =
        length > 0
            ? std::clamp(QVector3D::dotProduct(point - each.start, span) / length, 0.0f, 1.0f)
            : 0;
    const float radius = each.start_radius + along * (each.end_radius - each.start_radius);
    nearest = std::min(
        nearest, static_cast<double>(point.distanceToPoint(each.start + along * span) - radius));
  }
  return nearest;
}

TEST(FigureShape, AHumanHasABody) {
  for (const bool floor : {false, true}) {
    const Skeleton skeleton = human(floor);
    const Eigen::MatrixXd tracks =
        landmark_tracks(skeleton, {.channels = Eigen::MatrixXd::Zero(1, skeleton.channel_count())});
    const std::vector<Capsule> body = posed(FigureShape(skeleton), tracks, 0);
    // The skull is above the head joint and as high as a human's.
    EXPECT_LT(outside(body, {0, 168, 2}), 0);
    EXPECT_GT(outside(body, {0, 184, 2}), 0);
    EXPECT_LT(outside(body, {6, 169, 2}), 0);
    // The trunk has volume between its bones and ends before the arms.
    EXPECT_LT(outside(body, {9, 135, 0}), 0);
    EXPECT_LT(outside(body, {6, 135, 7}), 0);
    EXPECT_GT(outside(body, {0, 135, 20}), 0);
    EXPECT_LT(outside(body, {8, 108, 0}), 0);
    // There are heels, and hands beyond the last joints.
    for (const float side : {18.0f, -18.0f}) EXPECT_LT(outside(body, {side, 80, 0}), 0);
    for (const float side : {9.0f, -9.0f}) EXPECT_LT(outside(body, {side, 4, 0}), 0);
    // Only feet touch the ground, and nothing is between the legs.
    EXPECT_GT(outside(body, {0, 3, 0}), 2);
    EXPECT_GT(outside(body, {0, 50, 0}), 0);
  }
}

TEST(FigureShape, IsTheSameOnBothSides) {
  const Skeleton skeleton = human(false);
  const Eigen::MatrixXd tracks =
      landmark_tracks(skeleton, {.channels = Eigen::MatrixXd::Zero(1, skeleton.channel_count())});
  const std::vector<Capsule> body = posed(FigureShape(skeleton), tracks, 0);
  for (float y = 0; y < 180; y += 7)
    for (float x = 0; x < 40; x += 5)
      EXPECT_NEAR(outside(body, {x, y, 3}), outside(body, {-x, y, 3}), 1e-3) << x << ' ' << y;
}

/// In FBX and glTF files the joints' rest rotations are in the channels: with channels at zero both
/// arms are above the chest.
TEST(FigureShape, HasTheProportionsOfTheClipNotOfItsChannelsAtZero) {
  const Skeleton standing = human(false);
  Skeleton turned;
  for (Joint each : standing.joints()) {
    if (each.name == "LeftArm" || each.name == "RightArm") each.offset = {0, 14, 0};
    if (each.name.ends_with("Shoulder") || each.name.ends_with("tArm"))
      each.channels = {ChannelKind::RotationZ};
    turned.add(each);
  }
  Eigen::MatrixXd channels = Eigen::MatrixXd::Zero(1, turned.channel_count());
  for (const char* name : {"LeftShoulder", "RightArm"})
    channels(0, turned.first_channel(turned.find(name))) = -std::numbers::pi / 2;
  for (const char* name : {"RightShoulder", "LeftArm"})
    channels(0, turned.first_channel(turned.find(name))) = std::numbers::pi / 2;
  const Eigen::MatrixXd tracks = landmark_tracks(turned, {.channels = channels});
  const std::vector<Capsule> expected = posed(FigureShape(standing), tracks, 0);
  const std::vector<Capsule> body = posed(FigureShape(turned, tracks), tracks, 0);
  ASSERT_EQ(body.size(), expected.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    EXPECT_NEAR(body[i].start_radius, expected[i].start_radius, 1e-3) << i;
    EXPECT_LT(body[i].start.distanceToPoint(expected[i].start), 1e-3) << i;
    EXPECT_LT(body[i].end.distanceToPoint(expected[i].end), 1e-3) << i;
  }
  EXPECT_GT(outside(posed(FigureShape(turned), tracks, 0), {6, 135, 7}), 0);
}

TEST(FigureShape, AThingHasACapsuleOnEverySegmentAndABallOnEveryJoint) {
  const Motion motion = test::smooth_motion(4);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  const FigureShape shape(motion.skeleton);
  const std::vector<Segment> segments = motion.skeleton.segments();
  const auto joints = static_cast<std::size_t>(motion.skeleton.joint_count());
  const std::vector<Capsule> capsules = posed(shape, tracks, 3);

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

TEST(FigureShape, ARingAroundAJointIsWiderThanTheBodyThere) {
  const Skeleton skeleton = human(false);
  const Eigen::MatrixXd tracks =
      landmark_tracks(skeleton, {.channels = Eigen::MatrixXd::Zero(1, skeleton.channel_count())});
  const FigureShape shape(skeleton);
  const std::vector<Capsule> body = posed(shape, tracks, 0);
  for (const char* name : {"LeftLeg", "RightForeArm"}) {
    const int joint = skeleton.find(name);
    const float radius = shape.ringRadius(joint);
    EXPECT_GT(outside(body, landmarkAt(tracks, 0, joint) + QVector3D(0, 0, radius)), 0) << name;
    EXPECT_LT(radius, 12) << name;
  }
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
    EXPECT_NEAR(posed(shape, tracks, 0)[1].start_radius / size, 0.034, 1e-5);
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
  for (const QVector3D& point : shape.body(tracks, 0)) EXPECT_GT(point.x(), 850);

  EXPECT_EQ(FigureShape(test::small_skeleton()).bodyRoot(), 0);
}

}  // namespace
}  // namespace mocapress
