// SPDX-License-Identifier: MIT
// Our BVH files as read by Blender (Debian's package blender).
#include <gtest/gtest.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/base/file.h"
#include "core/formats/bvh.h"
#include "core/motion/landmarks.h"
#include "tests/support/corpus.h"
#include "tests/support/test_motion.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;

constexpr double kMove = 1e-3;  // cm
constexpr int kSampledFrames = 12;

/// A motion for Blender as a BVH, and the unit of the file.
struct Exported {
  std::string title;
  Motion motion;
  BvhStyle style;
};

class Blender : public CommandLine {
 protected:
  void add(const std::string& title, const Motion& motion, const BvhStyle& style = {}) {
    exported_.push_back({title, motion, style});
  }

  /// Adds a file, written again in its source's conventions.
  void add_file(const fs::path& path) {
    const MotionFile file = read_motion(path);
    add(path.string(), file.motion, bvh_style(file.source));
  }

  /// Bone positions in Blender for each file; empty without a Blender that starts.
  nlohmann::json positions() {
    std::vector<std::string> arguments = {std::to_string(kSampledFrames)};
    for (std::size_t i = 0; i < exported_.size(); ++i)
      arguments.push_back(write("clip" + std::to_string(i) + ".bvh",
                                bvh_text(exported_[i].motion, exported_[i].style)));
    return run_blender("blender_positions.py", arguments);
  }

  /// The largest distance (cm) between a joint's origin in Blender and ours; reports all other
  /// differences.
  static double largest_move(const Exported& exported, const nlohmann::json& found) {
    constexpr std::size_t kLongestName = 63;  // bytes; Blender truncates longer names
    const Motion& motion = exported.motion;
    if (found.contains("error")) {
      ADD_FAILURE() << exported.title << ": " << found["error"];
      return 0;
    }
    if (found["frames"] != motion.clip.frames()) {
      ADD_FAILURE() << exported.title << ": " << found["frames"] << " frames";
      return 0;
    }
    std::unordered_map<std::string, std::size_t> bone_named;
    for (const auto& bone : found["bones"])
      bone_named.emplace(bone.get<std::string>(), bone_named.size());
    EXPECT_EQ(std::ssize(bone_named), motion.skeleton.joint_count()) << exported.title;
    const std::vector<std::string> names = bvh_names(motion.skeleton);
    const Eigen::MatrixXd tracks = landmark_tracks(motion.skeleton, motion.clip);
    double largest = 0;
    for (std::size_t row = 0; row < found["sampled"].size(); ++row)
      for (std::size_t joint = 0; joint < names.size(); ++joint) {
        const auto bone = bone_named.find(names[joint].substr(0, kLongestName));
        if (bone == bone_named.end()) {
          ADD_FAILURE() << exported.title << ": no bone " << names[joint];
          return 0;
        }
        const auto head = found["heads"][row][bone->second].get<std::vector<double>>();
        const Eigen::RowVector3d cm =
            exported.style.cm_per_unit * Eigen::RowVector3d(head[0], head[1], head[2]);
        const auto at = tracks.block<1, 3>(found["sampled"][row].get<int>(),
                                           3 * static_cast<Eigen::Index>(joint));
        largest = std::max(largest, (cm - at).norm());
      }
    return largest;
  }

  std::vector<Exported> exported_;
};

/// A figure with everything that confuses importers: joints with no, one or two channels, names of
/// several words, names that are keywords or quotes, a repeated name, joints that translate, two
/// joints in one place, and two roots.
Motion awkward_motion() {
  using enum ChannelKind;
  Skeleton skeleton;
  skeleton.add({.name = "the root",
                .offset = {3, 90, 1},
                .channels = {TranslationX, TranslationY, TranslationZ, RotationY}});
  const auto add = [&](const char* name, int parent, std::vector<ChannelKind> channels) {
    return skeleton.add({.name = name,
                         .parent = parent,
                         .offset = {4, 20.0 + skeleton.joint_count(), -3},
                         .channels = std::move(channels)});
  };
  const int still = add("no channel", 0, {});
  const int one = add("End", still, {RotationX});
  const int two = add("JOINT", one, {RotationZ, RotationX});
  const int moving = add("twice", two, {RotationY, TranslationY, RotationX, RotationZ});
  add("twice", moving, {RotationX, RotationY, RotationZ});
  add("a \"quoted\" \\ name", moving, {RotationZ, RotationX, RotationY});
  add("\u5de6\u8155", one, {RotationX, RotationZ, RotationY});
  add("not \xff UTF-8", one, {RotationY, RotationX});
  skeleton.add({.name = "same place", .parent = one, .channels = {RotationZ}});
  skeleton.add({.name = std::string(80, 'n'),
                .parent = two,
                .offset = {0, 5, 0},
                .channels = {RotationZ, RotationX, RotationZ}});
  const int second = skeleton.add(
      {.name = "second root", .offset = {70, 10, 5}, .channels = {RotationZ, TranslationX}});
  add("below it", second, {RotationX});
  Motion motion{skeleton, {}};
  motion.clip.channels = Eigen::MatrixXd::NullaryExpr(
      30, skeleton.channel_count(), [&](Eigen::Index t, Eigen::Index c) {
        const double wave = std::sin(0.2 * static_cast<double>(t) + static_cast<double>(3 * c));
        return is_rotation(skeleton.channel_kind(static_cast<int>(c))) ? wave : 30 * wave;
      });
  return motion;
}

TEST_F(Blender, OpensEveryExportAndPutsEveryJointInItsPlace) {
  if (run_program({"sh", "-c", "command -v blender"}).exit_code != 0)
    GTEST_SKIP() << "Blender is not installed";
  for (const char* sample : {"human_walk.amc", "human_jump.amc"})
    add_file(fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples" / sample);
  add("turned axes", smooth_motion(60));
  const Motion awkward = awkward_motion();
  add("awkward", awkward);
  add("awkward, its root replacing", awkward, {.root = TranslationConvention::Replaces});
  add("awkward, in inches", awkward, {.cm_per_unit = 2.54});
  if (const auto folder = corpus())
    for (const char* clip :
         {"study/09_01.amc", "bvh/cmu_12_01_walk.bvh", "bvh/iclone_006_05_60hz_100joints.bvh",
          "odd/bvh_test1.bvh", "odd/makehuman_benchmark_1frame_891ch_6chan_joints.bvh",
          "odd/cmu16_11_blender_reexport_96dof_bones_not_in_asf_dof.amc"})
      if (fs::exists(*folder / clip)) add_file(*folder / clip);

  const nlohmann::json found = positions();
  if (found.is_null()) GTEST_SKIP() << "Blender does not start here";
  ASSERT_EQ(found.size(), exported_.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_LT(largest_move(exported_[i], found[i]), kMove) << exported_[i].title;
}

// Takes some minutes. Run by hand.
TEST_F(Blender, DISABLED_OpensEveryClipOfTheCorpus) {
  const auto folder = corpus();
  if (!folder) GTEST_SKIP() << "the corpus of real motions is not here";
  for (const auto& entry : fs::recursive_directory_iterator(*folder))
    if (entry.path().extension() == ".bvh" || entry.path().extension() == ".amc")
      add_file(entry.path());
  const nlohmann::json found = positions();
  ASSERT_EQ(found.size(), exported_.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double move = largest_move(exported_[i], found[i]);
    std::cout << move << " cm " << exported_[i].title << '\n';
    EXPECT_LT(move, kMove) << exported_[i].title;
  }
}

}  // namespace
}  // namespace mocapress::test
