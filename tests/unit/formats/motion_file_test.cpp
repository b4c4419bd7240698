// SPDX-License-Identifier: MIT
#include "core/formats/motion_file.h"

#include <gtest/gtest.h>

#include "core/base/file.h"
#include "core/formats/asf.h"
#include "tests/support/motion_texts.h"
#include "tests/support/same_motion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

constexpr double kMove = 1e-4;  // cm

/// A folder of its own for each test, removed at its end.
class MotionFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        fs::path(testing::TempDir()) /
        (std::string("mocapress-") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string error_of(const std::string& name) {
    try {
      read_motion(folder_ / name);
    } catch (const InputError& error) {
      return std::string(error.what()).substr(folder_.string().size() + 1);
    }
    return "reads";
  }

  fs::path folder_;
};

TEST_F(MotionFiles, GoByTheirExtensionWhateverItsCase) {
  write_text(folder_ / "a.BVH", test::kSmallBvh);
  EXPECT_EQ(read_motion(folder_ / "a.BVH").motion.clip.frames(), 2);
  write_text(folder_ / "a.asf", test::kSmallAsf);
  write_text(folder_ / "a.Amc", test::kSmallAmc);
  EXPECT_EQ(read_motion(folder_ / "a.Amc").motion.clip.frames(), 3);
}

TEST_F(MotionFiles, FindTheSkeletonOfTheSameNameBeforeThatOfTheSubject) {
  write_text(folder_ / "09_01.amc", test::kSmallAmc);
  EXPECT_EQ(error_of("09_01.amc"),
            "09_01.amc: needs its skeleton, but neither 09_01.asf nor 09.asf is beside it");
  write_text(folder_ / "09.ASF", test::kSmallAsf);
  EXPECT_EQ(read_motion(folder_ / "09_01.amc").motion.skeleton.joint_count(), 4);
  write_text(folder_ / "09_01.asf", "nonsense");
  EXPECT_EQ(error_of("09_01.amc").find("09_01.asf:1:1: expected a section"), 0u);
  EXPECT_NO_THROW(read_motion(folder_ / "09_01.amc", folder_ / "09.ASF"));
}

TEST_F(MotionFiles, RefuseWhatIsNoMotion) {
  write_text(folder_ / "a.asf", test::kSmallAsf);
  EXPECT_EQ(error_of("a.asf"), "a.asf: is a skeleton without motion: open one of its .amc files");
  EXPECT_EQ(error_of("a.fbx"), "a.fbx: is neither .bvh nor .amc");
  EXPECT_EQ(error_of("none.bvh"), "none.bvh: No such file or directory");
  EXPECT_THROW(write_motion(folder_ / "a.fbx", test::smooth_motion(2)), Error);
}

TEST_F(MotionFiles, ComeBackAsTheyWereWritten) {
  const Motion motion = test::smooth_motion(30);
  write_motion(folder_ / "out.amc", motion);
  EXPECT_TRUE(fs::exists(folder_ / "out.asf"));
  EXPECT_LT(test::largest_move(motion, read_motion(folder_ / "out.amc").motion,
                               asf_names(motion.skeleton)),
            kMove);
  write_motion(folder_ / "b.amc", motion, folder_ / "other.asf");
  EXPECT_FALSE(fs::exists(folder_ / "b.asf"));
  EXPECT_NO_THROW(read_motion(folder_ / "b.amc", folder_ / "other.asf"));
  write_motion(folder_ / "out.CSV", motion);
  EXPECT_EQ(read_text(folder_ / "out.CSV").find("time_s,"), 0u);
  EXPECT_THROW(write_motion(folder_ / "no" / "such" / "folder.bvh", motion), WriteError);
}

}  // namespace
}  // namespace mocapress
