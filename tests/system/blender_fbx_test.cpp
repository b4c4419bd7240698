// SPDX-License-Identifier: MIT
// FBX files that Blender wrote, and as Blender reads them (Debian's package blender).
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/formats/bvh.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class BlenderFbx : public CommandLine {};

TEST_F(BlenderFbx, WritesWhatIsReadBackInItsPlace) {
  const Motion walk =
      read_motion(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/human_walk.amc").motion;
  const std::string bvh = write("walk.bvh", bvh_text(walk, {.cm_per_unit = 1}));
  if (run_blender("blender_fbx.py", {bvh}).is_null())
    GTEST_SKIP() << "there is no Blender that starts";
  const Motion back = read_motion(bvh + ".fbx").motion;
  EXPECT_EQ(back.clip.sample_rate_hz, walk.clip.sample_rate_hz);
  ASSERT_EQ(back.clip.frames(), walk.clip.frames());
  const Eigen::MatrixXd wanted = landmark_tracks(walk.skeleton, walk.clip);
  const Eigen::MatrixXd found = landmark_tracks(back.skeleton, back.clip);
  const std::vector<std::string> names = bvh_names(walk.skeleton);
  for (int j = 0; j < walk.skeleton.joint_count(); ++j) {
    const int same = back.skeleton.find(names[static_cast<std::size_t>(j)]);
    ASSERT_GE(same, 0) << names[static_cast<std::size_t>(j)];
    EXPECT_LT(
        (found.middleCols<3>(3 * same) - wanted.middleCols<3>(3 * j)).rowwise().norm().maxCoeff(),
        0.01)
        << names[static_cast<std::size_t>(j)];
  }
}

TEST_F(BlenderFbx, ReadsEveryFrameAsWeDo) {
  const auto folder = corpus();
  if (!folder || !fs::exists(*folder / "fbx"))
    GTEST_SKIP() << "the corpus of real motions is not here";
  std::map<std::string, MotionFile> ours;  // by what blender_fbx.py is told
  for (const auto& [name, first] : std::map<std::string, int>{
           {"85_12.fbx", 68}, {"animation_with_skeleton.fbx", 1}, {"huesitos.fbx", 1}}) {
    const std::string path = (*folder / "fbx" / name).string();
    MotionFile motion = read_motion(path);
    const int frames = motion.motion.clip.frames();
    ours[path + "@" + std::to_string(first) + "@" + std::to_string(frames)] = std::move(motion);
  }
  std::vector<std::string> files;
  for (const auto& [file, motion] : ours) files.push_back(file);
  const nlohmann::json all = run_blender("blender_fbx.py", files);
  if (all.is_null()) GTEST_SKIP() << "there is no Blender that starts";
  for (const auto& [file, read] : ours) {
    const Eigen::MatrixXd tracks = landmark_tracks(read.motion.skeleton, read.motion.clip);
    double largest = 0;
    for (int t = 0; t < read.motion.clip.frames(); ++t)
      for (const auto& [bone, at] : all.at(file).at(static_cast<std::size_t>(t)).items())
        if (const int j = read.motion.skeleton.find(bone); j >= 0)
          largest = std::max(
              largest,
              (tracks.block<1, 3>(t, 3 * j) - Eigen::RowVector3d(at[0], at[1], at[2])).norm());
    std::cout << largest << " cm " << file << '\n';
    EXPECT_LT(largest, 0.01) << file;
  }
}

}  // namespace
}  // namespace mocapress::test
