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
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress::fbx_writer_test {
namespace {

namespace fs = std::filesystem;

/// The largest distance (cm) of a joint of `motion` from its namesake in `again`, over all frames.
double largest_move(const Motion& motion, const Motion& again) {
  EXPECT_EQ(again.clip.frames(), motion.clip.frames());
  EXPECT_NEAR(again.clip.sample_rate_hz, motion.clip.sample_rate_hz, 1e-6);
  const Eigen::MatrixXd wanted = landmark_tracks(motion.skeleton, motion.clip);
  const Eigen::MatrixXd found = landmark_tracks(again.skeleton, again.clip);
  double largest = 0;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
    const int same = again.skeleton.find(motion.skeleton.joint(j).name);
    EXPECT_GE(same, 0) << motion.skeleton.joint(j).name;
    if (same >= 0)
      largest = std::max(largest, (found.middleCols<3>(3 * same) - wanted.middleCols<3>(3 * j))
                                      .rowwise()
                                      .norm()
                                      .maxCoeff());
  }
  return largest;
}

double round_trip(const Motion& motion, const SourceFormat& source = {},
                  const WriteOptions& options = {}, int version = kUsualFbxVersion) {
  const MotionFile again = read_fbx("again.fbx", fbx_bytes(motion, source, options, {}, version));
  EXPECT_TRUE(again.warnings.empty()) << again.warnings.front().text();
  return largest_move(motion, again.motion);
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
  const std::string bytes = fbx_bytes(motion, {}, {}, {}, 7700);
  EXPECT_EQ(FbxRecords("f", bytes).version(), 7700);
  EXPECT_LT(round_trip(motion, {}, {}, 7700), 1e-4);
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
      {.kind = TrackKind::ScaleX, .node = joint, .name = {}, .values = {1, 2, 3, 4}}};
  const MotionFile again = read_fbx("f.fbx", fbx_bytes(motion, {}, {}, tracks));
  EXPECT_LT(largest_move(motion, again.motion), 1e-4);
  for (const ScalarTrack& track : tracks)
    EXPECT_NE(std::find(again.tracks.begin(), again.tracks.end(), track), again.tracks.end())
        << label(track);
}

TEST(FbxWriter, LeavesNamesAsTheyAre) {
  Skeleton skeleton;
  for (const char* name : {"a:b c", "a:b c", "\xE9", ""}) skeleton.add({.name = name});
  EXPECT_EQ(fbx_names(skeleton), (std::vector<std::string>{"a:b c", "a:b c_2", "\xE9", "joint"}));
}

}  // namespace
}  // namespace mocapress::fbx_writer_test
