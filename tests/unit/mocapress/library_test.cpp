// SPDX-License-Identifier: MIT
// The library as its users have it: nothing here but its public headers, beside what checks them.
#include <gtest/gtest.h>

#include "core/formats/amc.h"
#include "core/formats/bvh.h"
#include "core/mocapress/mocapress.h"
#include "tests/support/loop_of.h"
#include "tests/support/test_motion.h"

namespace mocapress::library_test {
namespace {

constexpr int kFrames = 150;

const MotionFile& source() {
  static const MotionFile file{.motion = test::smooth_motion(kFrames)};
  return file;
}

const Encoded& encoded() {
  static const Encoded made = encode(source(), {.target = {Target::Kind::Error, 0.2}});
  return made;
}

TEST(Library, KeepsWhatTheTargetAsks) {
  EXPECT_TRUE(encoded().complete);
  EXPECT_GT(encoded().measurement.eps_bone_ends_cm, 0);
  EXPECT_LE(encoded().measurement.eps_bone_ends_cm, 0.2);
  EXPECT_EQ(encoded().measurement.file_bytes, encoded().file.size());
  EXPECT_GT(encoded().measurement.ratio, 1);
}

TEST(Library, MeasuresAFileAsItsEncoderDid) {
  const Measurement found = measure(source().motion, encoded().file);
  const Measurement& told = encoded().measurement;
  EXPECT_EQ(found.frames, kFrames);
  EXPECT_EQ(found.motion_bytes, told.motion_bytes);
  EXPECT_EQ(found.file_bytes, told.file_bytes);
  EXPECT_EQ(found.contacts, told.contacts);
  EXPECT_NEAR(found.eps_bone_ends_cm, told.eps_bone_ends_cm, 1e-6);
  EXPECT_NEAR(found.max_error_cm, told.max_error_cm, 1e-5);
  EXPECT_EQ(found.worst_frame, told.worst_frame);
}

TEST(Library, MeasuresNothingOfAnotherShape) {
  EXPECT_THROW(measure(test::smooth_motion(kFrames + 1), encoded().file), Error);
  EXPECT_THROW(measure(source().motion, {}), FormatError);
}

TEST(Library, StopsWhenItsObserverOrATokenSaysSo) {
  int calls = 0;
  const Encoded observed = encode(source(), {}, [&](const EncodeProgress&) {
    ++calls;
    return false;
  });
  EXPECT_FALSE(observed.complete);
  EXPECT_EQ(calls, 1);
  std::stop_source stop;
  stop.request_stop();
  const Encoded stopped = encode(source(), {}, {}, stop.get_token());
  EXPECT_FALSE(stopped.complete);
  EXPECT_NO_THROW(measure(source().motion, stopped.file)) << "what there was is a whole file";
}

TEST(Library, RefusesSettingsThatNoClipOrNotThisOneCanHave) {
  EXPECT_THROW(encode(source(), {.method = "magic"}), Error);
  EXPECT_THROW(encode(source(), {.correction = CorrectionSettings{.effectors = {"tail"}}}), Error);
  EXPECT_THROW(encode(source(), {.target = {Target::Kind::Size, 1}}), TargetMissed);
}

TEST(Library, PlaysWhatItDecompresses) {
  const Player player(encoded().file);
  const Motion motion = decompress(encoded().file).motion;
  const int joints = player.skeleton().joint_count();
  ASSERT_EQ(player.frames(), kFrames);
  ASSERT_EQ(motion.clip.frames(), kFrames);
  EXPECT_EQ(player.sample_rate_hz(), motion.clip.sample_rate_hz);
  EXPECT_NEAR(player.seconds(), (kFrames - 1) / player.sample_rate_hz(), 1e-12);
  const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
  for (const int frame : {0, 40, kFrames - 1}) {
    const double seconds = frame / player.sample_rate_hz();
    const Eigen::Matrix3Xf places = player.positions(seconds);
    const LocalPose pose = player.sample(seconds);
    std::vector<Eigen::Isometry3f> world(static_cast<std::size_t>(joints));
    for (int j = 0; j < joints; ++j) {
      const int parent = player.skeleton().joint(j).parent;
      Eigen::Isometry3f& own = world[static_cast<std::size_t>(j)];
      own = Eigen::Translation3f(pose.translation(j)) * pose.rotation(j);
      if (parent >= 0) own = world[static_cast<std::size_t>(parent)] * own;
      EXPECT_LT(
          (places.col(j).cast<double>() - tracks.row(frame).segment<3>(3 * j).transpose()).norm(),
          2e-3);
      EXPECT_LT((own.translation() - places.col(j)).norm(), 2e-3);
    }
  }
}

TEST(Library, HoldsThePoseBeforeAndAfterAClip) {
  const Player player(encoded().file);
  EXPECT_EQ(player.positions(-3), player.positions(0));
  EXPECT_EQ(player.positions(1e9), player.positions(player.seconds()));
  EXPECT_FALSE(player.is_loop());
  EXPECT_THROW(player.sample(0, AtEnds::Loop), Error);
  EXPECT_THROW(player.sample(std::numeric_limits<double>::quiet_NaN()), Error);
}

TEST(Library, GoesRoundWithALoop) {
  const MotionFile loop{.motion = test::loop_of(source().motion)};
  const Player player(encode(loop, {.loop = Loop::Repeats}).file);
  ASSERT_TRUE(player.is_loop());
  EXPECT_LT((player.sample(0.25, AtEnds::Loop).joints -
             player.sample(0.25 - player.seconds(), AtEnds::Loop).joints)
                .norm(),
            1e-2);
}

TEST(Library, ReadsAFileOfAnyMethodButPlaysWhatEnginesPlay) {
  const Encoded pca = encode(source(), {.method = "pca", .target = {Target::Kind::Ratio, 4}});
  EXPECT_EQ(decompress(pca.file).motion.clip.frames(), kFrames);
  EXPECT_GT(measure(source().motion, pca.file).eps_bone_ends_cm, 0);
  EXPECT_THROW(Player{pca.file}, FormatError);
  EXPECT_THROW(decompress({}), FormatError);
}

TEST(Library, ReadsTextsAsFiles) {
  const std::string bvh = bvh_text(source().motion);
  EXPECT_EQ(parse_motion("walk.BVH", bvh).motion.clip.frames(), kFrames);
  const Motion acclaim = acclaim_motion(source().motion);
  const MotionFile amc =
      parse_motion("walk.amc", amc_text(acclaim), asf_text(acclaim.skeleton), {});
  EXPECT_EQ(amc.motion.clip.frames(), kFrames);
  EXPECT_THROW(parse_motion("walk.amc", amc_text(acclaim)), InputError) << "without its skeleton";
  EXPECT_THROW(parse_motion("walk.fbx", bvh), InputError);
  EXPECT_THROW(parse_motion("walk.bvh", "HIERARCHY"), InputError);
}

}  // namespace
}  // namespace mocapress::library_test
