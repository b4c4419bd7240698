// SPDX-License-Identifier: MIT
#include "core/formats/node_motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "core/motion/landmarks.h"

namespace mocapress::node_motion_test {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kMove = 1e-6;  // cm
constexpr int kFrames = 20;

Quaterniond turn(double radians, const Vector3d& axis) {
  return Quaterniond(Eigen::AngleAxisd(radians, axis.normalized()));
}

/// A node that turns to and fro about its own axis without leaving its place.
std::vector<LocalTransform> turning(const Vector3d& place, const Vector3d& axis) {
  std::vector<LocalTransform> frames;
  for (int t = 0; t < kFrames; ++t) frames.push_back({place, turn(std::sin(0.3 * t), axis)});
  return frames;
}

AnimatedNode still(std::string name, int parent, const LocalTransform& rest, bool joint = false) {
  return {std::move(name), parent, joint, rest, {}};
}

AnimatedNode moving(std::string name, int parent, std::vector<LocalTransform> frames,
                    bool joint = false) {
  const LocalTransform rest = frames.front();
  return {std::move(name), parent, joint, rest, std::move(frames)};
}

/// Changes one frame of a node.
template <typename Change>
void change(AnimatedNode& node, int frame, const Change& change_local) {
  std::vector<LocalTransform> frames;
  for (std::size_t t = 0; t < node.frames.size(); ++t) frames.push_back(node.frames[t]);
  change_local(frames[static_cast<std::size_t>(frame)]);
  node.frames = frames;
}

NodeTake take_of(std::vector<AnimatedNode> nodes) {
  NodeTake take;
  take.nodes = std::move(nodes);
  take.frames = kFrames;
  return take;
}

MotionFile read(const NodeTake& take, const ReadOptions& options = {}) {
  return motion_of("f", take, options, SourceFormat::Kind::Fbx);
}

std::vector<std::string> names(const Motion& motion) {
  std::vector<std::string> names;
  for (const Joint& joint : motion.skeleton.joints()) names.push_back(joint.name);
  return names;
}

std::vector<std::string> texts(const MotionFile& file) {
  std::vector<std::string> texts;
  for (const Warning& warning : file.warnings) texts.push_back(warning.message);
  return texts;
}

int channels(const Motion& motion, const std::string& joint) {
  return static_cast<int>(motion.skeleton.joint(motion.skeleton.find(joint)).channels.size());
}

/// Expects every joint at the product of its nodes' transforms.
void expect_exact(const NodeTake& take, const Motion& motion) {
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  for (int t = 0; t < take.frames; ++t) {
    std::vector<Eigen::Affine3d> world;
    for (const AnimatedNode& node : take.nodes) {
      const LocalTransform& local =
          node.frames.empty() ? node.rest : node.frames[static_cast<std::size_t>(t)];
      Eigen::Affine3d above(Eigen::Scaling(take.cm_per_unit));
      if (node.parent >= 0) above = world[static_cast<std::size_t>(node.parent)];
      world.push_back(above * Eigen::Translation3d(local.translation) * local.rotation *
                      Eigen::Scaling(local.scale));
      const int joint = motion.skeleton.find(node.name);
      if (joint < 0) continue;
      const Eigen::RowVector3d found = tracks.block<1, 3>(t, 3 * joint);
      EXPECT_LT((found.transpose() - world.back().translation()).norm(), kMove)
          << node.name << " in frame " << t;
    }
  }
}

const Vector3d kX = Vector3d::UnitX();
const Vector3d kZ = Vector3d::UnitZ();

/// An armature as Blender's: of size 100, lying on its back.
NodeTake armature() {
  const LocalTransform stand{{10, 20, 30}, turn(-std::numbers::pi / 2, kX), {100, 100, 100}};
  return take_of({still("RootNode", -1, {}), still("Armature", 0, stand),
                  moving("Hips", 1, turning({0, 0, 0.9}, kX), true),
                  moving("Knee", 2, turning({0, -0.4, 0}, {1, 2, 3}), true),
                  moving("Foot", 3, turning({0, -0.4, 0.1}, kZ), true)});
}

TEST(NodeMotion, FoldsWhatStandsStillAboveTheRootAndPutsScaleIntoOffsets) {
  const NodeTake take = armature();
  const MotionFile file = read(take);
  EXPECT_THAT(names(file.motion), ElementsAre("Hips", "Knee", "Foot"));
  EXPECT_THAT(texts(file), IsEmpty());
  EXPECT_EQ(file.motion.skeleton.joint(0).parent, -1);
  EXPECT_NEAR(file.motion.skeleton.joint(1).offset.norm(), 40, kMove);
  EXPECT_EQ(file.motion.skeleton.channel_count(), 9);
  expect_exact(take, file.motion);
}

TEST(NodeMotion, KeepsAStandThatIsMarkedOrMoves) {
  NodeTake take = armature();
  take.nodes[1].joint = true;
  EXPECT_THAT(names(read(take).motion), ElementsAre("Armature", "Hips", "Knee", "Foot"));
  take.nodes[1].joint = false;
  take.nodes[1].frames = turning({10, 20, 30}, kX);
  EXPECT_THAT(names(read(take).motion), ElementsAre("Armature", "Hips", "Knee", "Foot"));
  expect_exact(take, read(take).motion);
}

TEST(NodeMotion, GivesTranslationChannelsOnlyToJointsThatSlide) {
  std::vector<LocalTransform> walk = turning({0, 90, 0}, kX);
  for (int t = 0; t < kFrames; ++t) walk[static_cast<std::size_t>(t)].translation.z() = 3.0 * t;
  const NodeTake take = take_of(
      {still("root", -1, {}, true), moving("Hips", 0, std::move(walk), true),
       moving("Knee", 1, turning({0, -40, 0}, kX), true), still("Toe", 2, {{0, 0, 10}}, true)});
  const Motion motion = read(take).motion;
  EXPECT_EQ(channels(motion, "root"), 0);
  EXPECT_EQ(channels(motion, "Hips"), 6);
  EXPECT_EQ(channels(motion, "Knee"), 3);
  EXPECT_EQ(channels(motion, "Toe"), 0);
  EXPECT_EQ(motion.skeleton.joint(1).offset, Vector3d(0, 90, 0));
  expect_exact(take, motion);
}

TEST(NodeMotion, KeepsPlacesWhereScaleChangesAndSaysSo) {
  NodeTake take = armature();
  for (int t = 0; t < kFrames; ++t)
    change(take.nodes[3], t,
           [&](LocalTransform& local) { local.scale = Vector3d::Constant(1 + 0.02 * t); });
  const MotionFile file = read(take);
  EXPECT_THAT(texts(file), ElementsAre(HasSubstr("1 node whose scale changes over time")));
  EXPECT_EQ(channels(file.motion, "Foot"), 6);
  expect_exact(take, file.motion);
  ASSERT_EQ(file.tracks.size(), 3u);
  EXPECT_EQ(label(file.tracks[1]), "Knee.scale-y");
  for (const ScalarTrack& track : file.tracks)
    for (int t = 0; t < kFrames; ++t)
      EXPECT_NEAR(track.values[static_cast<std::size_t>(t)], 1 + 0.02 * t, 1e-6);
}

TEST(NodeMotion, AClipOfTracksAloneHasAJointThatStandsStill) {
  NodeTake take = take_of({still("Head", -1, {{0, 1, 0}}, true)});
  EXPECT_THROW(read(take), InputError);
  take.tracks = {{.name = "smile", .values = std::vector<float>(kFrames, 0.5F)}};
  const MotionFile file = read(take);
  EXPECT_EQ(file.tracks, take.tracks);
  EXPECT_EQ(channels(file.motion, "Head"), 3);
  EXPECT_TRUE(file.motion.clip.channels.isZero(0));
  expect_exact(take, file.motion);
}

TEST(NodeMotion, KeepsPlacesBelowUnevenScaleAndMirrors) {
  NodeTake take = armature();
  take.nodes[1].rest.scale = {100, 50, -20};
  const MotionFile file = read(take);
  EXPECT_THAT(texts(file), ElementsAre(HasSubstr("1 node scaled unevenly, first Armature")));
  expect_exact(take, file.motion);
}

TEST(NodeMotion, LeavesOutWhatIsNoJointAndKnowsWhereBonesEnd) {
  const NodeTake take =
      take_of({moving("Hips", -1, turning({0, 90, 0}, kX), true),
               moving("camera", -1, turning({1, 2, 3}, kX)),
               moving("Head", 0, turning({0, 60, 0}, kZ), true), still("Head_end", 2, {{0, 20, 0}}),
               still("mesh", 0, {}), moving("sword", 2, turning({5, 0, 0}, kX))});
  const Motion motion = read(take).motion;
  EXPECT_THAT(names(motion), ElementsAre("Hips", "Head", "sword"));
  NodeTake without_sword = take;
  without_sword.nodes.pop_back();
  const Motion ended = read(without_sword).motion;
  EXPECT_THAT(names(ended), ElementsAre("Hips", "Head"));
  EXPECT_EQ(ended.skeleton.joint(1).end_site, Vector3d(0, 20, 0));
}

TEST(NodeMotion, TakesWhatMovesAndHangsFromThatWhereNothingIsMarked) {
  const NodeTake take =
      take_of({still("scene", -1, {}), still("group", 0, {{0, 5, 0}}),
               moving("a", 1, turning({1, 0, 0}, kX)), still("b", 2, {{0, 10, 0}}),
               still("c", 3, {{0, 10, 0}}), still("light", 0, {{9, 9, 9}})});
  const Motion motion = read(take).motion;
  EXPECT_THAT(names(motion), ElementsAre("a", "b", "c"));
  expect_exact(take, motion);
}

TEST(NodeMotion, AllowsSeveralRoots) {
  const NodeTake take =
      take_of({still("scene", -1, {}), moving("one", 0, turning({-50, 90, 0}, kX), true),
               moving("two", 0, turning({50, 90, 0}, kX), true)});
  const Motion motion = read(take).motion;
  EXPECT_EQ(motion.skeleton.joint(0).parent, -1);
  EXPECT_EQ(motion.skeleton.joint(1).parent, -1);
  expect_exact(take, motion);
}

TEST(NodeMotion, StripsASharedNamespaceAndNumbersNamesThatAreThereTwice) {
  const auto named = [](const char* a, const char* b, const char* c) {
    return read(take_of({moving(a, -1, turning({0, 9, 0}, kX), true),
                         moving(b, 0, turning({0, 9, 0}, kX), true),
                         moving(c, 1, turning({0, 9, 0}, kX), true)}));
  };
  EXPECT_THAT(names(named("m:Hips", "m:Spine", "m:Head").motion),
              ElementsAre("Hips", "Spine", "Head"));
  EXPECT_THAT(names(named("m:Hips", "Spine", "m:Head").motion),
              ElementsAre("m:Hips", "Spine", "m:Head"));
  const MotionFile twice = named("Bone", "Bone", "Bone");
  EXPECT_THAT(names(twice.motion), ElementsAre("Bone", "Bone.2", "Bone.3"));
  EXPECT_THAT(texts(twice), ElementsAre(HasSubstr("2 joints with the name of another joint")));
}

TEST(NodeMotion, KeepsAnglesContinuousAndAwayFromThePole) {
  std::vector<LocalTransform> frames;  // to a right angle about y, and several turns about z
  for (int t = 0; t < kFrames; ++t)
    frames.push_back({{0, 0, 0}, turn(0.9 * t, kZ) * turn(0.16 * t, Vector3d::UnitY())});
  const NodeTake take = take_of({moving("Hips", -1, std::move(frames), true)});
  const Motion motion = read(take).motion;
  ASSERT_EQ(motion.skeleton.channel_count(), 3);
  const Eigen::MatrixXd& angles = motion.clip.channels;
  EXPECT_LT((angles.bottomRows(kFrames - 1) - angles.topRows(kFrames - 1)).cwiseAbs().maxCoeff(),
            1.5);
  EXPECT_GT(angles.cwiseAbs().maxCoeff(), 0.9 * (kFrames - 1) - 1);  // turns add up
}

TEST(NodeMotion, ConvertsUnitsAndAxes) {
  NodeTake take = take_of({moving("Hips", -1, turning({1, 2, 3}, kX), true)});
  take.cm_per_unit = 2.54;
  take.up = UpAxis::Z;
  const MotionFile said = read(take);
  EXPECT_LT((said.motion.skeleton.joint(0).offset - 2.54 * Vector3d(1, 3, -2)).norm(), kMove);
  EXPECT_EQ(said.source,
            (SourceFormat{.kind = SourceFormat::Kind::Fbx, .cm_per_unit = 2.54, .up = UpAxis::Z}));
  const MotionFile told = read(take, {.cm_per_unit = 100.0, .up = UpAxis::Y});
  EXPECT_LT((told.motion.skeleton.joint(0).offset - Vector3d(100, 200, 300)).norm(), kMove);
}

TEST(NodeMotion, RefusesWhatNoMotionCanHold) {
  const auto message = [](const NodeTake& take) {
    try {
      read(take);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("read");
  };
  NodeTake take = armature();
  change(take.nodes[3], 7, [](LocalTransform& local) {
    local.translation.x() = std::numeric_limits<double>::quiet_NaN();
  });
  EXPECT_EQ(message(take), "f: Knee has a transform that is not finite, or beyond 1e9");
  change(take.nodes[3], 7, [](LocalTransform& local) {
    local = {{0, 0, 0}, Quaterniond(0, 0, 0, 0)};
  });
  EXPECT_EQ(message(take), "f: Knee has a transform that is not finite, or beyond 1e9");
  take = armature();
  take.nodes[1].rest.scale = Vector3d::Constant(1e9);
  take.nodes[2].rest.scale = Vector3d::Constant(1e9);
  change(take.nodes[2], 0, [](LocalTransform& local) { local.scale = Vector3d::Constant(1e9); });
  EXPECT_EQ(message(take), "f: Knee is farther than 1e9 cm away");
  EXPECT_EQ(message(take_of({still("light", -1, {})})),
            "f: has neither bones nor anything else that moves");
  EXPECT_THROW(check_take_size("f", 1, 1e7), InputError);
  EXPECT_THROW(check_take_size("f", 1000, 1e5), InputError);
  EXPECT_THROW(check_take_size("f", 1, std::numeric_limits<double>::quiet_NaN()), InputError);
  EXPECT_NO_THROW(check_take_size("f", 65, 1e5));
}

}  // namespace
}  // namespace mocapress::node_motion_test
