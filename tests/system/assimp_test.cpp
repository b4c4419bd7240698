// SPDX-License-Identifier: MIT
// Our FBX files as read by assimp (Debian's package assimp-utils). It converts them to glTF in the
// file's units.
#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "core/formats/fbx/fbx_writer.h"
#include "core/formats/node_motion.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"
#include "tests/support/test_motion.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

class Assimp : public CommandLine {};

TEST_F(Assimp, PutsEveryJointOfOursInItsPlace) {
  if (!is_installed("assimp")) GTEST_SKIP() << "assimp is not installed";
  const fs::path samples = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  std::map<std::string, MotionFile> clips = {{"walk", read_motion(samples / "human_walk.amc")},
                                             {"character", read_motion(samples / "character.fbx")},
                                             {"turned axes", {smooth_motion(60)}}};
  if (const auto folder = corpus()) clips["85_12"] = read_motion(*folder / "fbx/85_12.fbx");
  for (const auto& [title, clip] : clips) {
    const std::string path = file(title + ".fbx").string();
    const std::string as_gltf = file(title + ".glb").string();
    write_motion(path, clip.motion, {}, clip.source, {.cm_per_unit = 1.0, .up = UpAxis::Y});
    const Outcome outcome = run_program({"assimp", "export", path, as_gltf});
    ASSERT_EQ(outcome.exit_code, 0) << title << outcome.out << outcome.err;
    const Motion found =
        read_motion(as_gltf, {},
                    {.sample_rate_hz = clip.motion.clip.sample_rate_hz, .cm_per_unit = 1.0})
            .motion;
    ASSERT_EQ(found.clip.frames(), clip.motion.clip.frames()) << title;
    const std::vector<std::string> names = without_namespace(fbx_names(clip.motion.skeleton));
    const Eigen::MatrixXd wanted = landmark_tracks(clip.motion.skeleton, clip.motion.clip);
    const Eigen::MatrixXd tracks = landmark_tracks(found.skeleton, found.clip);
    double largest = 0;
    for (int j = 0; j < clip.motion.skeleton.joint_count(); ++j) {
      const int same = found.skeleton.find(names[static_cast<std::size_t>(j)]);
      ASSERT_GE(same, 0) << title << ' ' << names[static_cast<std::size_t>(j)];
      largest = std::max(largest, (tracks.middleCols<3>(3 * same) - wanted.middleCols<3>(3 * j))
                                      .rowwise()
                                      .norm()
                                      .maxCoeff());
    }
    std::cout << largest << " cm " << title << '\n';
    EXPECT_LT(largest, 1e-3) << title;
  }
}

}  // namespace
}  // namespace mocapress::test
