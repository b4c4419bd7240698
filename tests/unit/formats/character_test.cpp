// SPDX-License-Identifier: MIT
// The sample character, which glTF and FBX hold alike, read by both readers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "core/formats/motion_file.h"
#include "tests/support/corpus.h"
#include "tests/support/test_motion.h"

namespace mocapress::character_test {
namespace {

using Eigen::Vector3d;

class Character : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder_ / "character.glb")) GTEST_SKIP() << "no sample character";
  }

  static Pose pose_at(const Motion& motion, double seconds) {
    Pose pose;
    const auto frame = static_cast<Eigen::Index>(std::lround(seconds * motion.clip.sample_rate_hz));
    compute_pose(motion.skeleton, motion.clip.channels.row(frame), pose);
    return pose;
  }

  /// The largest distance (cm) of a point from the nearest of the others.
  static double farthest(const std::vector<Vector3d>& points, const std::vector<Vector3d>& others) {
    double worst = 0;
    for (std::size_t p = 0; p < points.size(); p += 7) {
      double nearest = 1e9;
      for (const Vector3d& other : others) nearest = std::min(nearest, (points[p] - other).norm());
      worst = std::max(worst, nearest);
    }
    return worst;
  }

  const std::filesystem::path folder_ =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
};

TEST_F(Character, IsTheSameFromGltfAndFbx) {
  const MotionFile gltf = read_motion(folder_ / "character.glb");
  const MotionFile fbx = read_motion(folder_ / "character.fbx");
  ASSERT_TRUE(gltf.skin && fbx.skin);
  EXPECT_EQ(gltf.skin->bones.size(), fbx.skin->bones.size());
  EXPECT_EQ(gltf.skin->triangles.size(), fbx.skin->triangles.size());
  for (const double seconds : {0.0, 0.5, 1.0, 1.5}) {
    const auto a = skinned_positions(*gltf.skin, pose_at(gltf.motion, seconds));
    const auto b = skinned_positions(*fbx.skin, pose_at(fbx.motion, seconds));
    EXPECT_LT(farthest(a, b), 0.05) << seconds;
    EXPECT_LT(farthest(b, a), 0.05) << seconds;
  }
}

TEST_F(Character, StandsAroundItsJoints) {
  const MotionFile file = read_motion(folder_ / "character.glb");
  const Pose pose = pose_at(file.motion, 1);
  const std::vector<Vector3d> places = skinned_positions(*file.skin, pose);
  EXPECT_LT(farthest(places, pose.origin), 30);
  EXPECT_LT(farthest(pose.origin, places), 15);
}

TEST_F(Character, IsPutOntoTheOtherFile) {
  const MotionFile fbx = read_motion(folder_ / "character.fbx");
  const auto [skeleton, skin] = read_character(folder_ / "character.glb");
  const Skin bound = bound_to(*skin, skeleton, fbx.motion.skeleton);
  const Pose pose = pose_at(fbx.motion, 1);
  EXPECT_LT(farthest(skinned_positions(bound, pose), skinned_positions(*fbx.skin, pose)), 0.05);
}

/// The clip's joints have other axes, but it moves in the same way.
TEST_F(Character, IsPutOntoAnAcclaimClip) {
  const MotionFile own = read_motion(folder_ / "character.glb");
  const MotionFile amc = read_motion(folder_ / "human_walk.amc");
  for (const char* name : {"character.glb", "character.fbx"}) {
    const auto [skeleton, skin] = read_character(folder_ / name);
    const Skin bound = bound_to(*skin, skeleton, amc.motion.skeleton);
    for (const double seconds : {0.0, 1.0})
      EXPECT_LT(farthest(skinned_positions(bound, pose_at(amc.motion, seconds)),
                         skinned_positions(*own.skin, pose_at(own.motion, seconds))),
                0.05)
          << name;
  }
}

TEST_F(Character, ThatIsPutOnIsWhatTheWeightingSkinMeasures) {
  MotionFile amc = read_motion(folder_ / "human_walk.amc");
  EXPECT_FALSE(amc.motion.skeleton.skin());
  put_character(folder_ / "character.glb", amc);
  ASSERT_TRUE(amc.motion.skeleton.skin());
  const MotionFile own = read_motion(folder_ / "character.glb");
  EXPECT_EQ(amc.motion.skeleton.skin()->size(), own.motion.skeleton.skin()->size());
}

TEST_F(Character, IsNotPutOntoJointsOfOtherNames) {
  MotionFile other{.motion = test::smooth_motion(10)};
  try {
    put_character(folder_ / "character.glb", other);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("character.glb: cannot be put on: the clip has "
                                                 "no joint"));
  }
  EXPECT_FALSE(other.skin);
}

TEST_F(Character, ThatDoesNotFitOneOfManyClipsIsLeftOffAndThatIsSaid) {
  const auto other = std::filesystem::path(testing::TempDir()) /
                     ("of-other-joints-" + std::to_string(getpid()) + ".bvh");
  write_motion(other, test::smooth_motion(10));
  ReadOptions options;
  options.character = (folder_ / "character.glb").string();
  const MotionFile kept = read_motion_of_many(other, {}, options);
  EXPECT_FALSE(kept.skin);
  ASSERT_FALSE(kept.warnings.empty());
  EXPECT_THAT(kept.warnings.back().text(),
              testing::HasSubstr("character.glb: is not put on: the clip has no joint"));
  EXPECT_TRUE(read_motion_of_many(folder_ / "human_walk.amc", {}, options).skin);
  options.character = "gone.glb";
  EXPECT_THROW(read_motion_of_many(other, {}, options), InputError);
  std::filesystem::remove(other);
}

/// As a clip of another body, without its hands.
TEST_F(Character, SaysWhatTheClipLacksAndThatProportionsDiffer) {
  MotionFile clip = read_motion(folder_ / "human_walk.amc");
  Skeleton shorter;
  for (Joint joint : clip.motion.skeleton.joints()) {
    joint.offset *= 0.8;
    if (joint.name == "lhand") joint.name = "mitten";
    shorter.add(joint);
  }
  ASSERT_GE(shorter.find("mitten"), 0);
  clip.motion.skeleton = shorter;
  clip.warnings.clear();
  put_character(folder_ / "character.glb", clip);
  ASSERT_GE(clip.warnings.size(), 2U);
  EXPECT_THAT(clip.warnings[0].text(),
              testing::HasSubstr("character.glb: the clip has no joint lhand: what hangs there"));
  EXPECT_THAT(clip.warnings[1].text(), testing::HasSubstr("legs of 125 % the length"));
}

TEST_F(Character, ComesWithoutItsMotion) {
  const auto [skeleton, skin] = read_character(folder_ / "character.fbx");
  EXPECT_EQ(skeleton.joint_count(), 31);
  EXPECT_EQ(skin->bones.size(), 30U);
}

TEST_F(Character, IsReadOfFilesThatHaveMeshes) {
  EXPECT_THROW(read_character(folder_ / "human_walk.amc"), InputError);
}

}  // namespace
}  // namespace mocapress::character_test
