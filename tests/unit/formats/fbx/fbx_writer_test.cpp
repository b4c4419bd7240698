// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/formats/fbx/fbx_animation.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress::fbx_writer_test {
namespace {

namespace fs = std::filesystem;
using test::largest_joint_move;

double round_trip(const Motion& motion, const SourceFormat& source = {},
                  const WriteOptions& options = {}) {
  const MotionFile again = read_fbx("again.fbx", fbx_bytes(motion, source, options));
  EXPECT_TRUE(again.warnings.empty()) << again.warnings.front().text();
  return largest_joint_move(motion, again.motion);
}

fs::path sample(const char* name) {
  return fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples" / name;
}

TEST(FbxWriter, GivesBackEverySample) {
  for (const char* name : {"human_walk.amc", "human_run.amc", "human_jump.amc", "character.fbx"}) {
    const MotionFile file = read_motion(sample(name));
    EXPECT_LT(round_trip(file.motion, file.source), 1e-4) << name;
  }
}

TEST(FbxWriter, WritesTheUnitAndTheAxesThatAreAskedFor) {
  const Motion motion = test::smooth_motion(20);
  EXPECT_LT(round_trip(motion, {}, {.cm_per_unit = 100.0}), 1e-4);
  EXPECT_LT(round_trip(motion, {}, {.up = UpAxis::Z}), 1e-4);
  const MotionFile file =
      read_fbx("f", fbx_bytes(motion, {}, {.cm_per_unit = 100.0, .up = UpAxis::Z}));
  EXPECT_EQ(file.source,
            (SourceFormat{.kind = SourceFormat::Kind::Fbx, .cm_per_unit = 100, .up = UpAxis::Z}));
}

TEST(FbxWriter, WritesRecordsOf64BitsWhereAskedTo) {
  const Motion motion = test::smooth_motion(20);
  const std::string bytes = fbx_bytes(motion, {}, {.fbx_version = 7700});
  EXPECT_EQ(FbxRecords("f", bytes).version(), 7700);
  EXPECT_LT(round_trip(motion, {}, {.fbx_version = 7700}), 1e-4);
}

TEST(FbxWriter, KeepsRatesThatHaveNoNumberOfTheirOwn) {
  Motion motion = test::smooth_motion(20);
  for (const double rate : {24.0, 30000.0 / 1001, 119.88, 240.0}) {
    motion.clip.sample_rate_hz = rate;
    EXPECT_LT(round_trip(motion), 1e-4) << rate;
  }
}

TEST(FbxWriter, RestsTheRootAtTheOrigin) {
  const MotionFile character = read_motion(sample("character.fbx"));
  const std::string bytes = fbx_bytes(character.motion, character.source);
  FbxFile file("f.fbx", bytes);
  const FbxTake take = read_fbx_take(file, {});
  EXPECT_EQ(take.take.nodes[1].parent, 0);  // below the scene
  EXPECT_TRUE(take.transforms[1].translation.isZero(1e-9));
}

TEST(FbxWriter, MakesTheSameBytes) {
  const Motion motion = test::smooth_motion(20);
  EXPECT_EQ(fbx_bytes(motion), fbx_bytes(motion));
}

TEST(FbxWriter, GoesOnWithAnglesBeyondATurn) {
  Motion motion;
  motion.skeleton.add({.name = "wheel", .channels = {ChannelKind::RotationX}});
  motion.clip = {30, Eigen::VectorXd::LinSpaced(91, 0, 6 * std::numbers::pi)};
  const std::string bytes = fbx_bytes(motion);
  FbxFile file("wheel.fbx", bytes);
  FbxAnimation animation(file.records, file.objects, kFbxTicks);
  double last = 0;
  for (const FbxMovement& movement : animation.movements(0)) {
    if (movement.property != "Lcl Rotation") continue;
    for (const FbxCurve::Key& key : movement.curves[0]->keys()) {
      EXPECT_LT(std::abs(key.value - last), 180);
      last = key.value;
    }
  }
  EXPECT_NEAR(last, 1080, 1e-3);
}

TEST(FbxWriter, TurnsEachJointInTheOrderOfItsChannels) {
  Motion motion;
  motion.skeleton.add(
      {.name = "hip",
       .channels = {ChannelKind::RotationX, ChannelKind::RotationZ, ChannelKind::RotationY}});
  motion.clip = {30, Eigen::MatrixXd::Random(5, 3)};
  const std::string bytes = fbx_bytes(motion);
  FbxFile file("hip.fbx", bytes);
  FbxAnimation animation(file.records, file.objects, kFbxTicks);
  for (const FbxMovement& movement : animation.movements(0)) {
    if (movement.property != "Lcl Rotation") continue;
    const FbxTransform transform(file.objects.properties(movement.object));
    EXPECT_EQ(transform.order, 2);  // YZX: about Y first
    constexpr int kChannelOfAxis[] = {0, 2, 1};
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t t = 0; t < 5; ++t)
        EXPECT_NEAR(movement.curves[axis]->keys()[t].value * std::numbers::pi / 180,
                    motion.clip.channels(static_cast<Eigen::Index>(t), kChannelOfAxis[axis]), 1e-6);
  }
}

TEST(FbxWriter, KeepsTracksThatChange) {
  const Motion motion = test::smooth_motion(4);
  const std::string joint = motion.skeleton.joint(1).name;
  const ScalarTracks tracks = {
      {.kind = TrackKind::Property, .node = joint, .name = "grip", .values = {0, 1, 2, 5}},
      {.kind = TrackKind::Property,
       .node = "event",
       .name = "step",
       .steps = true,
       .values = {0, 1, 1, 0}},
      {.kind = TrackKind::Property,
       .node = "event",
       .name = "Visibility",
       .steps = true,
       .values = {1, 0, 0, 1}},
      {.kind = TrackKind::MorphWeight,
       .node = "Face",
       .name = "smile",
       .values = {0, 1, 0.5, 0.25}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "blink", .values = {1, 0, 0, 0}},
      {.kind = TrackKind::MorphWeight, .node = "Face", .name = "blink", .values = {0, 0, 1, 0}},
      {.kind = TrackKind::ScaleX, .node = joint, .name = {}, .values = {1, 2, 3, 4}}};
  const MotionFile again = read_fbx("f.fbx", fbx_bytes(motion, {}, {}, tracks));
  EXPECT_LT(largest_joint_move(motion, again.motion), 1e-4);
  for (const ScalarTrack& track : tracks)
    EXPECT_NE(std::find(again.tracks.begin(), again.tracks.end(), track), again.tracks.end())
        << label(track);
}

TEST(FbxWriter, PutsSeveralClipsOfARigIntoOneFileEachAtItsRate) {
  const Motion walk = test::smooth_motion(20);
  Motion jump = test::smooth_motion(31);
  jump.clip.sample_rate_hz = 24;
  for (int c = 0; c < jump.skeleton.channel_count(); ++c)
    jump.clip.channels.col(c).array() += is_rotation(jump.skeleton.channel_kind(c)) ? 0.3 : 5;
  const auto weights = [](std::size_t frames, float scale) {
    ScalarTracks tracks = {
        {.kind = TrackKind::MorphWeight, .node = "Face", .name = "smile", .values = {}},
        {.kind = TrackKind::Property, .node = "event", .name = "step", .values = {}}};
    for (ScalarTrack& track : tracks)
      for (std::size_t t = 0; t < frames; ++t)
        track.values.push_back(scale * static_cast<float>(t) / static_cast<float>(frames));
    return tracks;
  };
  const ScalarTracks of_walk = weights(20, 1);
  const ScalarTracks of_jump = weights(31, 0.5F);
  const std::string bytes =
      fbx_bytes(std::vector<FbxClip>{{"walk", walk, of_walk}, {"jump", jump, of_jump}});
  const auto judge = [&](const char* take, const Motion& motion, const ScalarTracks& tracks) {
    const MotionFile again = read_fbx("f.fbx", bytes, {.take = take});
    EXPECT_EQ(again.takes.keys, (std::vector<std::string>{"walk", "jump"}));
    EXPECT_LT(largest_joint_move(motion, again.motion), 1e-4) << take;
    ASSERT_EQ(again.tracks.size(), 2u) << take;
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t t = 0; t < tracks[i].values.size(); ++t)
        EXPECT_NEAR(again.tracks[i].values[t], tracks[i].values[t], 1e-6) << take << ' ' << i;
  };
  judge("walk", walk, of_walk);
  judge("jump", jump, of_jump);
}

TEST(FbxWriter, PlacesAJointThatRestsElsewhereThanItStands) {
  Motion motion;
  motion.skeleton.add({.name = "hip", .channels = {ChannelKind::RotationX}});
  motion.skeleton.add({.name = "slider",
                       .parent = 0,
                       .offset = {0, 10, 0},
                       .channels = {ChannelKind::TranslationX}});
  motion.clip = {30, Eigen::MatrixXd::Constant(5, 2, 3)};
  motion.clip.channels.col(0).setLinSpaced(0, 1);
  EXPECT_LT(round_trip(motion), 1e-4);
}

TEST(FbxWriter, LeavesNamesAsTheyAre) {
  Skeleton skeleton;
  for (const char* name : {"a:b c", "a:b c", "\xE9", ""}) skeleton.add({.name = name});
  EXPECT_EQ(fbx_names(skeleton), (std::vector<std::string>{"a:b c", "a:b c_2", "\xE9", "joint"}));
}

}  // namespace
}  // namespace mocapress::fbx_writer_test
