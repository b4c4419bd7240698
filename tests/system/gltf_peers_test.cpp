// SPDX-License-Identifier: MIT
// Our glTF files in other programs: the Khronos validator (npm's gltf-validator) and Blender's
// importer (Debian's package blender).
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/base/file.h"
#include "core/formats/gltf_writer.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"
#include "tests/support/small_gltf.h"
#include "tests/support/test_motion.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

constexpr double kImportedMove = 1e-3;  // cm

/// A motion, and its file for the other programs.
struct Given {
  std::string title;
  Motion motion;
  std::string file;
};

class GltfPeers : public CommandLine {
 protected:
  void give(const std::string& title, const MotionFile& read, GltfContainer container) {
    const char* extension = container == GltfContainer::Glb ? ".glb" : ".gltf";
    const std::string name = "given" + std::to_string(given_.size()) + extension;
    given_.push_back(
        {title, read.motion, write(name, gltf_bytes(read.motion, container, read.source))});
  }

  /// Adds `source` with its own motion written onto it.
  void give_onto(const fs::path& source) {
    const MotionFile read = read_motion(source);
    const bool binary = source.extension() == ".glb";
    const std::string name = "given" + std::to_string(given_.size()) + source.extension().string();
    given_.push_back(
        {source.string(), read.motion,
         write(name, gltf_bytes_onto(source, read.motion,
                                     binary ? GltfContainer::Glb : GltfContainer::Gltf,
                                     fs::path(file(name)).parent_path(), read.source))});
  }

  void give_all() {
    const fs::path samples = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
    give("walk", read_motion(samples / "human_walk.amc"), GltfContainer::Glb);
    give("jump", read_motion(samples / "human_jump.amc"), GltfContainer::Gltf);
    give("turned axes", {smooth_motion(60)}, GltfContainer::Glb);
    MotionFile two_roots{smooth_motion(20)};
    two_roots.motion.skeleton.add({.name = "prop", .offset = {30, 5, 0}});
    give("two roots", two_roots, GltfContainer::Glb);
    give_onto(write("knee.glb", bending_knee().glb()));
    const auto folder = corpus();
    if (!folder) return;
    for (const char* clip : {"study/09_01.amc", "bvh/iclone_006_05_60hz_100joints.bvh"})
      give(clip, read_motion(*folder / clip), GltfContainer::Glb);
    give("skin", read_motion(*folder / "gltf/simple_skin.gltf"), GltfContainer::Glb);
  }

  std::vector<std::string> files() const {
    std::vector<std::string> files;
    for (const Given& given : given_) files.push_back(given.file);
    return files;
  }

  std::vector<Given> given_;
};

/// The largest distance (cm) between a joint's origin in Blender and ours.
double largest_move(const Given& given, const nlohmann::json& found) {
  constexpr std::size_t kLongestName = 63;  // bytes; Blender truncates longer names
  if (found.contains("error")) {
    ADD_FAILURE() << given.title << ": " << found["error"];
    return 0;
  }
  EXPECT_EQ(found["frames"], given.motion.clip.frames()) << given.title;
  std::unordered_map<std::string, std::size_t> bone_named;
  for (const auto& bone : found["bones"])
    bone_named.emplace(bone.get<std::string>(), bone_named.size());
  EXPECT_EQ(std::ssize(bone_named), given.motion.skeleton.joint_count()) << given.title;
  const std::vector<std::string> names = gltf_names(given.motion.skeleton);
  const Eigen::MatrixXd tracks = landmark_tracks(given.motion.skeleton, given.motion.clip);
  double largest = 0;
  for (std::size_t row = 0; row < found["sampled"].size(); ++row)
    for (std::size_t joint = 0; joint < names.size(); ++joint) {
      const auto bone = bone_named.find(names[joint].substr(0, kLongestName));
      if (bone == bone_named.end()) {
        ADD_FAILURE() << given.title << ": no bone " << names[joint];
        return 0;
      }
      const auto head = found["heads"][row][bone->second].get<std::vector<double>>();
      const auto at = tracks.block<1, 3>(found["sampled"][row].get<int>(),
                                         3 * static_cast<Eigen::Index>(joint));
      largest =
          std::max(largest, (100 * Eigen::RowVector3d(head[0], head[1], head[2]) - at).norm());
    }
  return largest;
}

TEST_F(GltfPeers, TheKhronosValidatorFindsNoErrorAndNoWarning) {
  const std::string modules = std::string(MOCAPRESS_SOURCE_DIR) + "/build/node/node_modules";
  if (!is_installed("node") || !fs::exists(modules + "/gltf-validator"))
    GTEST_SKIP() << "tests/run installs gltf-validator where npm is; it is not here";
  give_all();
  std::vector<std::string> words = {
      "env", "NODE_PATH=" + modules, "node",
      std::string(MOCAPRESS_SOURCE_DIR) + "/tests/system/gltf_validate.js"};
  for (const std::string& file : files()) words.push_back(file);
  const Outcome outcome = run_program(words);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
}

TEST_F(GltfPeers, BlenderPutsEveryJointInItsPlace) {
  give_all();
  std::vector<std::string> arguments = {"12"};
  for (const std::string& file : files()) arguments.push_back(file);
  const nlohmann::json found = run_blender("blender_gltf_positions.py", arguments);
  if (found.is_null()) GTEST_SKIP() << "there is no Blender that starts";
  ASSERT_EQ(found.size(), given_.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double move = largest_move(given_[i], found[i]);
    RecordProperty(given_[i].title, std::to_string(move));
    EXPECT_LT(move, kImportedMove) << given_[i].title;
  }
}

}  // namespace
}  // namespace mocapress::test
