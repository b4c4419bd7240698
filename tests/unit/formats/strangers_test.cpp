// SPDX-License-Identifier: MIT
// Files from strangers (the corpus's folder `strangers`; its README has the right values), and the
// messages for files that cannot be read.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/formats/clip_files.h"
#include "core/formats/motion_file.h"
#include "core/motion/forward_kinematics.h"
#include "tests/support/corpus.h"

namespace mocapress::strangers_test {
namespace {

namespace fs = std::filesystem;

class Strangers : public testing::Test {
 protected:
  void SetUp() override {
    const auto found = test::corpus();
    if (!found || !fs::exists(*found / "strangers"))
      GTEST_SKIP() << "the corpus of real motions is not here";
    corpus_ = *found;
  }

  MotionFile read(const std::string& name) const {
    return read_motion(corpus_ / "strangers" / name);
  }

  fs::path corpus_;
};

TEST_F(Strangers, GltfFilesReadAsTheReadmeSays) {
  const MotionFile base = read("g_base.gltf");
  EXPECT_EQ(base.motion.clip.frames(), 31);
  EXPECT_EQ(base.motion.clip.sample_rate_hz, 30);
  EXPECT_TRUE(base.warnings.empty());
  const MotionFile pointer = read("g_pointer.gltf");
  EXPECT_EQ(pointer.motion.clip.channels, base.motion.clip.channels);
  EXPECT_TRUE(pointer.warnings.empty());
  const MotionFile milliseconds = read("g_ms30.gltf");
  EXPECT_EQ(milliseconds.motion.clip.sample_rate_hz, 30);
  EXPECT_EQ(milliseconds.motion.clip.frames(), 91);
  EXPECT_TRUE(milliseconds.warnings.empty());
}

/// Both figures equal the one of the plain file; the second stands elsewhere.
TEST_F(Strangers, WithTwoCharactersHaveBoth) {
  const Motion one = read("g_base.gltf").motion;
  const Motion two = read("g_twochars.gltf").motion;
  ASSERT_EQ(two.skeleton.joint_count(), 2 * one.skeleton.joint_count());
  EXPECT_EQ(std::count_if(two.skeleton.joints().begin(), two.skeleton.joints().end(),
                          [](const Joint& joint) { return joint.parent < 0; }),
            2);
  Pose alone;
  Pose both;
  for (const int frame : {0, 10, 30}) {
    compute_pose(one.skeleton, one.clip.channels.row(frame), alone);
    compute_pose(two.skeleton, two.clip.channels.row(frame), both);
    for (int j = 0; j < one.skeleton.joint_count(); ++j) {
      const auto there = static_cast<std::size_t>(two.skeleton.find(one.skeleton.joint(j).name));
      EXPECT_LT((both.origin.at(there) - alone.origin[static_cast<std::size_t>(j)]).norm(), 1e-4);
    }
  }
}

TEST_F(Strangers, WithTwoRootsReadAsTheyStand) {
  const Motion motion = read("two_roots_min.bvh").motion;
  ASSERT_EQ(motion.skeleton.joint_count(), 4);
  EXPECT_EQ(motion.clip.frames(), 3);
  Pose pose;
  compute_pose(motion.skeleton, motion.clip.channels.row(2), pose);
  EXPECT_LT((pose.origin[0] - Eigen::Vector3d(2, 90, 0)).norm(), 1e-9);
  EXPECT_LT((pose.origin[2] - Eigen::Vector3d(102, 90, 0)).norm(), 1e-9);
  EXPECT_THROW(write_motion(fs::path(testing::TempDir()) / "two_roots.amc", motion), WriteError);
}

TEST_F(Strangers, ThatGitLfsHasNotFetchedAreNamedAsSuch) {
  try {
    read("lfs_pointer.fbx");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is a pointer of Git LFS"), std::string::npos);
  }
}

/// Expects one sentence: a line of printable characters that is not cut off.
void expect_sentence(const std::string& message, const std::string& file) {
  EXPECT_LE(message.size(), 200u) << file << ": " << message;
  EXPECT_FALSE(message.empty()) << file;
  EXPECT_TRUE(std::all_of(message.begin(), message.end(),
                          [](unsigned char c) { return c >= 0x20 && c < 0x7F; }))
      << file << ": " << message;
  EXPECT_FALSE(message.ends_with("...")) << file << ": " << message;
}

TEST_F(Strangers, AreRefusedOrWarnedOfInOneSentence) {
  int read = 0;
  int refused = 0;
  for (const char* folder : {"attack", "bvh", "gltf", "odd", "strangers"})
    for (const auto& entry : fs::directory_iterator(corpus_ / folder)) {
      const fs::path& path = entry.path();
      if (!is_clip(path) || path.extension() == ".fbx") continue;
      try {
        for (const Warning& warning : read_motion(path).warnings)
          expect_sentence(warning.message, path.string());
        ++read;
      } catch (const InputError& error) {
        const std::string text = error.what();
        const std::size_t message = text.find(": ");
        ASSERT_TRUE(message != text.npos) << text;
        expect_sentence(text.substr(message + 2), path.string());
        ++refused;
      }
    }
  EXPECT_GT(read, 15);
  EXPECT_GE(refused, 3);
}

}  // namespace
}  // namespace mocapress::strangers_test
