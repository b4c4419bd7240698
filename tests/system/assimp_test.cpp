// SPDX-License-Identifier: MIT
// FBX files of ours as assimp reads them (Debian's package assimp-utils). It hands on what it read
// as glTF, in the file's numbers.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

struct Cost {
  double seconds = 0;  // processor time
  double megabytes = 0;
};

/// A program's, without what it says.
Cost cost_of(const std::vector<std::string>& words) {
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << words[0] << ' ' << words.back();
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return {seconds(used.ru_utime) + seconds(used.ru_stime),
          static_cast<double>(used.ru_maxrss) / 1024};
}

/// The same clip again and again, up to so many frames.
Motion repeated(Motion motion, int frames) {
  const Eigen::MatrixXd once = motion.clip.channels;
  motion.clip.channels.resize(frames, once.cols());
  for (int t = 0; t < frames; ++t) motion.clip.channels.row(t) = once.row(t % once.rows());
  return motion;
}

// By hand: prints the table of time and memory of JUDGED.md, the best of three turns.
TEST_F(Assimp, DISABLED_TakesTimeAndMemoryBesideUs) {
  if (!is_installed("assimp")) GTEST_SKIP() << "assimp is not installed";
  const auto folder = corpus();
  if (!folder) GTEST_SKIP() << "the corpus of real motions is not here";
  const std::string large = file("large.fbx").string();
  constexpr int kFrames = 32'000;
  // By another process: what this one took would count as that of the programs it starts.
  if (const pid_t child = fork(); child == 0) {
    const Motion once = read_motion(*folder / "bvh/iclone_006_05_60hz_100joints.bvh").motion;
    write_motion(large, repeated(once, kFrames));
    _exit(0);
  } else {
    waitpid(child, nullptr, 0);
  }
  for (const std::string& path :
       {large, (*folder / "fbx/85_12.fbx").string(),
        (fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.fbx").string(),
        (*folder / "fbx/animation_with_skeleton.fbx").string()}) {
    Cost ours{1e9, 1e9};
    Cost theirs = ours;
    const auto keep_least = [](Cost& least, const Cost& cost) {
      least = {std::min(least.seconds, cost.seconds), std::min(least.megabytes, cost.megabytes)};
    };
    for (int turn = 0; turn < 3; ++turn) {
      keep_least(ours, cost_of({MOCAPRESS_EXECUTABLE, "info", path}));
      keep_least(theirs, cost_of({"assimp", "info", path, "--raw"}));
    }
    std::cout << "| " << fs::path(path).filename().string() << " | "
              << static_cast<double>(fs::file_size(path)) / 1e6 << " | " << ours.seconds << " | "
              << theirs.seconds << " | " << ours.megabytes << " | " << theirs.megabytes << " |\n";
  }
}

}  // namespace
}  // namespace mocapress::test
