// SPDX-License-Identifier: MIT
// FBX files that the command line writes.
#include <gmock/gmock.h>

#include "core/base/file.h"
#include "core/formats/fbx/fbx_records.h"
#include "core/formats/motion_file.h"
#include "tests/support/same_motion.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

class CliFbx : public CommandLine {
 protected:
  const std::string packed_ = file("clip.mcpr");
};

TEST_F(CliFbx, PutsAMotionOntoAnFbxAtAnotherRateThanItsOwn) {
  const std::string character =
      std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/character.fbx";
  const std::string output = file("moved.fbx");
  ASSERT_EQ(
      mocapress({"compress", character, "-o", packed_, "--rate", "60", "--target-error", "0.01"})
          .exit_code,
      0);
  ASSERT_EQ(mocapress({"decompress", packed_, "-o", output, "--onto", character}).exit_code, 0);
  const MotionFile source = read_motion(character, {}, {.sample_rate_hz = 60.0});
  const MotionFile found = read_motion(output, {}, {.sample_rate_hz = 60.0});
  EXPECT_NE(found.skin, nullptr);
  EXPECT_EQ(read_motion(output).motion.clip.sample_rate_hz, 60);
  EXPECT_LT(largest_joint_move(source.motion, found.motion), 0.2);
  EXPECT_EQ(
      mocapress({"decompress", packed_, "-o", file("moved.glb"), "--onto", character}).exit_code,
      2);
}

TEST_F(CliFbx, PutsSeveralClipsOfARigIntoOneFbxATakeEach) {
  const std::string samples = std::string(MOCAPRESS_SOURCE_DIR) + "/resources/samples/";
  std::vector<std::string> words = {"decompress"};
  for (const char* clip : {"human_walk", "human_run"}) {
    words.push_back(file(clip + std::string(".mcpr")));
    ASSERT_EQ(mocapress({"compress", samples + clip + ".amc", "-o", words.back()}).exit_code, 0);
  }
  const auto onto = [&](const std::string& output, const std::vector<std::string>& more) {
    std::vector<std::string> all = words;
    all.insert(all.end(), {"-o", output});
    all.insert(all.end(), more.begin(), more.end());
    return mocapress(all);
  };
  const std::string output = file("moves.fbx");
  ASSERT_EQ(onto(output, {"--fbx-version", "7.7"}).exit_code, 0);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string take = std::filesystem::path(words[i]).stem().string();
    const MotionFile found = read_motion(output, {}, {.take = take});
    EXPECT_EQ(found.takes.keys, (std::vector<std::string>{"human_walk", "human_run"}));
    const std::string alone = file("alone.fbx");
    ASSERT_EQ(mocapress({"decompress", words[i], "-o", alone}).exit_code, 0);
    EXPECT_LT(largest_joint_move(read_motion(alone).motion, found.motion), 1e-6) << take;
  }
  EXPECT_EQ(onto(file("moves.bvh"), {}).exit_code, 2);
  EXPECT_EQ(onto(output, {"--onto", output}).exit_code, 2);
  EXPECT_EQ(onto(output, {"--fbx-version", "6.1"}).exit_code, 2);
  ASSERT_EQ(mocapress({"compress", write("other.bvh", test_bvh()), "-o", packed_}).exit_code, 0);
  words.push_back(packed_);
  EXPECT_EQ(onto(output, {}).exit_code, 3);
}

TEST_F(CliFbx, ABatchWritesTheVersionAskedFor) {
  std::filesystem::create_directories(file("in"));
  write("in/clip.bvh", test_bvh());
  const auto batch = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"batch",    file("in"), "-o",     file(out),
                                      "--format", "fbx",      "--jobs", "1"};
    words.insert(words.end(), more.begin(), more.end());
    return mocapress(words).exit_code;
  };
  const auto version = [&](const std::string& out) {
    const std::string name = file(out) / "in/clip.fbx";
    const std::string bytes = read_text(name);
    return FbxRecords(name, bytes).version();
  };
  ASSERT_EQ(batch("plain", {}), 0);
  ASSERT_EQ(batch("newer", {"--fbx-version", "7.7"}), 0);
  EXPECT_EQ(version("plain"), 7400);
  EXPECT_EQ(version("newer"), 7700);
  EXPECT_EQ(batch("older", {"--fbx-version", "6.1"}), 2);
}

/// Takes share nodes by their place in the list of joints.
TEST_F(CliFbx, TakesOfJointsInAnotherOrderAreRefused) {
  const auto bvh = [](const std::string& first, const std::string& second) {
    const auto arm = [](const std::string& name, const std::string& x) {
      return "  JOINT " + name + "\n  {\n    OFFSET " + x +
             " 0 0\n    CHANNELS 3 Zrotation Xrotation Yrotation\n    End Site\n    {\n"
             "      OFFSET 0 -40 0\n    }\n  }\n";
    };
    return "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 90 0\n  CHANNELS 6 Xposition Yposition Zposition "
           "Zrotation Xrotation Yrotation\n" +
           arm(first, first == "L" ? "20" : "-20") + arm(second, second == "L" ? "20" : "-20") +
           "}\nMOTION\nFrames: 2\nFrame Time: 0.033\n0 90 0 0 0 0 1 2 3 4 5 6\n"
           "1 90 0 0 0 0 7 8 9 1 2 3\n";
  };
  const std::string left = file("left.mcpr");
  const std::string right = file("right.mcpr");
  const auto compress = [&](const std::string& source, const std::string& output) {
    return mocapress({"compress", source, "-o", output, "--target-error", "0.1"}).exit_code;
  };
  ASSERT_EQ(compress(write("l.bvh", bvh("L", "R")), left), 0);
  ASSERT_EQ(compress(write("r.bvh", bvh("R", "L")), right), 0);
  const Outcome refused = mocapress({"decompress", left, right, "-o", file("both.fbx")});
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, testing::HasSubstr("another order"));
}

}  // namespace
}  // namespace mocapress::test
