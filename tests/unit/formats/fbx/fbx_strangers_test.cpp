// SPDX-License-Identifier: MIT
// Small files after what people reported of other readers, with the right values.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"

namespace mocapress::fbx_strangers_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FbxStrangers : public testing::Test {
 protected:
  void SetUp() override {
    const auto corpus = test::corpus();
    if (!corpus || !fs::exists(*corpus / "strangers"))
      GTEST_SKIP() << "the corpus of strangers' files is not here";
    folder_ = *corpus / "strangers";
  }

  MotionFile read(const std::string& name, const ReadOptions& options = {}) const {
    return read_motion(folder_ / name, {}, options);
  }
  static Eigen::Vector3d place(const MotionFile& file, const std::string& joint, int frame) {
    const Eigen::MatrixXd tracks = landmark_tracks(file.motion.skeleton, file.motion.clip);
    return tracks.block<1, 3>(frame, 3 * file.motion.skeleton.find(joint)).transpose();
  }
  void expect_at_a_third(const std::string& name, const std::string& joint,
                         const Eigen::Vector3d& expected) const {
    const Eigen::Vector3d found = place(read(name), joint, 10);
    EXPECT_LT((found - expected).norm(), 1e-3) << name << ": " << found.transpose();
  }

  fs::path folder_;
};

TEST_F(FbxStrangers, InvertsPostRotation) {
  for (const char* name : {"f_post1.fbx", "f_post1_bin.fbx"})
    expect_at_a_third(name, "Head", {43.460, 92.936, 15.301});
}

TEST_F(FbxStrangers, LeavesOutPreRotationThatIsNotActive) {
  for (const char* name : {"f_rotoff_pre.fbx", "f_rotoff_pre_bin.fbx"})
    expect_at_a_third(name, "Head", {34.872, 139.217, 46.674});
}

TEST_F(FbxStrangers, CompensatesTheScaleOfASegment) {
  for (const char* name : {"f_inherit.fbx", "f_inherit_bin.fbx"})
    expect_at_a_third(name, "Foot", {-5.884, -27.226, 3.775});
}

TEST_F(FbxStrangers, StaysWhereASteppedCurveStays) {
  const MotionFile stepped = read("f_step.fbx");
  const int root = 0;
  ASSERT_EQ(stepped.motion.clip.frames(), 31);
  const Eigen::MatrixXd tracks = landmark_tracks(stepped.motion.skeleton, stepped.motion.clip);
  EXPECT_EQ(tracks(1, 3 * root), tracks(0, 3 * root));
  EXPECT_EQ(tracks(9, 3 * root), tracks(0, 3 * root));
}

TEST_F(FbxStrangers, CutsAClipFromItsTimeLine) {
  EXPECT_EQ(read("f_clips_full.fbx", {.take = "2"}).motion.clip.frames(), 20);
  EXPECT_EQ(read("f_span.fbx").motion.clip.frames(), 11);
}

TEST_F(FbxStrangers, ReadsKeysBesideAFrameAtTheRateOfTheFile) {
  const MotionFile file = read("f_offframe.fbx");
  EXPECT_EQ(file.motion.clip.sample_rate_hz, 30);
  EXPECT_EQ(file.motion.clip.frames(), 31);
}

TEST_F(FbxStrangers, PassesOverATakeThatStandsStill) {
  const MotionFile file = read("f_mixamo.fbx");
  ASSERT_FALSE(file.warnings.empty());
  EXPECT_THAT(file.warnings.front().message, HasSubstr("take mixamo.com is read"));
}

TEST_F(FbxStrangers, ReadsIdsBelowZero) {
  const MotionFile negative = read("f_negid.fbx");
  const MotionFile base = read("f_base.fbx");
  EXPECT_EQ(negative.motion.clip.channels, base.motion.clip.channels);
}

TEST_F(FbxStrangers, NamesAPointerOfGitLfs) {
  try {
    read("lfs_pointer.fbx");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("Git LFS"));
  }
}

TEST_F(FbxStrangers, CountsAConnectionThatIsStatedTwiceOnceAndSaysSo) {
  const Motion wanted = read("../fbx/animation_with_skeleton.fbx").motion;
  for (const char* name : {"dup_AnimationCurveNode_Node.fbx", "dup_Deformer_Deformer.fbx"}) {
    const MotionFile found = read(std::string("../attack/") + name);
    EXPECT_EQ(found.motion.clip.channels, wanted.clip.channels) << name;
    EXPECT_NE(found.skin, nullptr) << name;
    EXPECT_THAT(found.warnings,
                testing::Contains(testing::Field(&Warning::message,
                                                 "1 connection stated again: each counts once")));
  }
}

TEST_F(FbxStrangers, LeavesOutAMeshWhoseWeightsCannotBeThere) {
  const std::string name = "../attack/inflate_4gb.fbx";
  const std::string reason = "an array states more values than its bytes can hold (byte 50970)";
  const MotionFile found = read(name);
  EXPECT_EQ(found.motion.clip.channels, read("../fbx/huesitos.fbx").motion.clip.channels);
  EXPECT_EQ(found.skin, nullptr);
  EXPECT_THAT(found.warnings, testing::Contains(testing::Field(
                                  &Warning::message, "its character is not read: " + reason)));
  try {
    read_character(folder_ / name);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(reason));
  }
}

TEST_F(FbxStrangers, RefusesOrReadsManglesInOneSentence) {
  for (const char* folder : {"fbx_fuzz", "attack"})
    for (const auto& entry : fs::directory_iterator(folder_.parent_path() / folder)) {
      if (entry.path().extension() != ".fbx") continue;
      std::string verdict;
      try {
        parse_motion(entry.path().filename(), read_text(entry.path()));
      } catch (const InputError& error) {
        verdict = error.what();
      }
      EXPECT_EQ(verdict.find('\n'), verdict.npos) << entry.path();
      EXPECT_LE(verdict.size(), 200u) << verdict;
    }
}

}  // namespace
}  // namespace mocapress::fbx_strangers_test
