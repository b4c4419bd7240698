// SPDX-License-Identifier: MIT
#include "core/formats/motion_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>

#include "core/base/file.h"
#include "core/codec/encode/encoder.h"
#include "core/formats/asf.h"
#include "core/formats/bvh.h"
#include "core/formats/clip_files.h"
#include "tests/support/motion_texts.h"
#include "tests/support/same_motion.h"
#include "tests/support/small_gltf.h"
#include "tests/support/test_motion.h"

namespace mocapress::motion_file_test {
namespace {

namespace fs = std::filesystem;

constexpr double kMove = 1e-4;  // cm

/// A folder of its own for each test, removed at its end.
class MotionFiles : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("mocapress-" + std::to_string(getpid()));
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

TEST_F(MotionFiles, HaveTheCurvesOfTheTableBesideThem) {
  const Motion motion = test::smooth_motion(3);
  write_text(folder_ / "walk.bvh", bvh_text(motion));
  write_text(folder_ / "walk.csv", "not a table of curves");
  EXPECT_TRUE(read_motion(folder_ / "walk.bvh").tracks.empty());
  write_text(folder_ / "walk.tracks.csv", "step\n0\n1\n1\n");
  write_text(folder_ / "other.csv", "reach\n0.5\n0.6\n0.7\n");
  const ScalarTracks beside = read_motion(folder_ / "walk.bvh").tracks;
  ASSERT_EQ(beside.size(), 1U);
  EXPECT_EQ(beside[0].name, "step");
  const ReadOptions told{.tracks = (folder_ / "other.csv").string()};
  const ScalarTracks named = read_motion(folder_ / "walk.bvh", {}, told).tracks;
  ASSERT_EQ(named.size(), 1U);
  EXPECT_EQ(named[0].name, "reach");
  write_text(folder_ / "walk.tracks.csv", "step\n0\n");
  EXPECT_EQ(error_of("walk.bvh"),
            "walk.tracks.csv:2:1: ends after values of 1 frame, the clip has 3");
}

/// A clip of differences, which joints add to another clip's rotations.
TEST_F(MotionFiles, WithoutLengthsAreMeasuredByHowJointsTurn) {
  write_text(folder_ / "added.bvh",
             "HIERARCHY ROOT Hips { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation JOINT "
             "Head { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation End Site { OFFSET 0 0 0 "
             "} } } MOTION Frames: 4 Frame Time: 0.01\n0 0 0 0 0 0\n1 2 3 4 5 6\n2 4 6 8 10 "
             "12\n1 2 3 4 5 6\n");
  MotionFile file = read_motion(folder_ / "added.bvh");
  ASSERT_EQ(file.warnings.size(), 1U);
  EXPECT_EQ(file.warnings[0].message,
            "no bone has a length: errors are measured on three points 3 cm from each joint");
  const Encoder encoder(std::move(file.motion));
  const Encoding made = encoder.encode({.method = Method::ClosedLoop,
                                        .weighting = Weighting::Surface,
                                        .target = {Target::Kind::Error, 0.01}});
  EXPECT_LE(made.distortion.eps(Weighting::Surface), 0.01);
  EXPECT_LE(made.distortion.joint_degrees.maxCoeff(), 1);
}

TEST_F(MotionFiles, AreNotWrittenWithValuesThatAreNotFinite) {
  write_text(folder_ / "a.bvh", test::kSmallBvh);
  Motion motion = read_motion(folder_ / "a.bvh").motion;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    motion.clip.channels(1, 0) = bad;
    for (const char* name : {"b.bvh", "b.csv", "b.glb", "b.amc"}) {
      EXPECT_THROW(write_motion(folder_ / name, motion), Error);
      EXPECT_FALSE(fs::exists(folder_ / name));
    }
  }
}

TEST_F(MotionFiles, ReplaceNothingWhereThatIsRefused) {
  write_text(folder_ / "a.bvh", test::kSmallBvh);
  const Motion motion = read_motion(folder_ / "a.bvh").motion;
  constexpr auto kRefuse = StagedFile::Existing::Refuse;
  for (const char* name : {"b.bvh", "b.csv", "b.glb", "b.amc"}) {
    write_text(folder_ / name, "mine");
    EXPECT_THROW(write_motion(folder_ / name, motion, folder_ / "b.asf", {}, {}, {}, kRefuse),
                 WriteError);
    EXPECT_EQ(read_text(folder_ / name), "mine");
    EXPECT_FALSE(fs::exists(folder_ / "b.asf"));
    fs::remove(folder_ / name);
    write_motion(folder_ / name, motion, folder_ / "b.asf", {}, {}, {}, kRefuse);
    EXPECT_NE(read_text(folder_ / name), "mine");
    fs::remove(folder_ / "b.asf");
  }
}

TEST_F(MotionFiles, GoByTheirExtensionWhateverItsCase) {
  write_text(folder_ / "a.BVH", test::kSmallBvh);
  EXPECT_EQ(read_motion(folder_ / "a.BVH").motion.clip.frames(), 2);
  write_text(folder_ / "a.asf", test::kSmallAsf);
  write_text(folder_ / "a.Amc", test::kSmallAmc);
  EXPECT_EQ(read_motion(folder_ / "a.Amc").motion.clip.frames(), 3);
  // Models and animations of VRM are .glb by another name.
  for (const char* name : {"a.glb", "a.vrm", "a.VRMA"}) {
    write_text(folder_ / name, test::bending_knee().glb());
    EXPECT_EQ(read_motion(folder_ / name).motion.clip.frames(), 11);
    EXPECT_TRUE(is_clip(name));
  }
}

/// An exception of a library becomes a sentence about the file: here JSON that is no text.
TEST_F(MotionFiles, NeverThrowAnythingButASentence) {
  for (const char* name : {"a.gltf", "a.bvh", "a.vrm"}) {
    write_text(folder_ / name, std::string("\xFF\x00{\"asset\"", 11));
    EXPECT_NE(error_of(name), "reads");
  }
}

TEST_F(MotionFiles, FindTheSkeletonOfTheSameNameBeforeThatOfTheSubject) {
  write_text(folder_ / "09_01.amc", test::kSmallAmc);
  EXPECT_EQ(error_of("09_01.amc"),
            "09_01.amc: needs its skeleton, but neither 09_01.asf nor 09.asf is beside it");
  write_text(folder_ / "09.amc", test::kSmallAmc);
  EXPECT_EQ(error_of("09.amc"), "09.amc: needs its skeleton, but 09.asf is not beside it");
  write_text(folder_ / "09.ASF", test::kSmallAsf);
  EXPECT_EQ(read_motion(folder_ / "09_01.amc").motion.skeleton.joint_count(), 4);
  write_text(folder_ / "09_01.asf", "nonsense");
  EXPECT_EQ(error_of("09_01.amc").find("09_01.asf:1:1: expected a section"), 0u);
  EXPECT_NO_THROW(read_motion(folder_ / "09_01.amc", folder_ / "09.ASF"));
}

TEST_F(MotionFiles, RefuseWhatIsNoMotion) {
  write_text(folder_ / "a.asf", test::kSmallAsf);
  EXPECT_EQ(error_of("a.asf"), "a.asf: is a skeleton without motion: open one of its .amc files");
  EXPECT_EQ(error_of("a.txt"), "a.txt: is none of .bvh, .amc, .fbx, .gltf, .glb, .vrm, .vrma");
  EXPECT_EQ(error_of("none.bvh"), "none.bvh: No such file or directory");
  EXPECT_THROW(write_motion(folder_ / "a.txt", test::smooth_motion(2)), Error);
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

/// Reads a text, writes it as its source was, and returns the new text.
std::string rewritten(const std::string& text, const ReadOptions& reading = {},
                      const WriteOptions& writing = {}) {
  const MotionFile file = read_bvh("f.bvh", text, reading);
  const fs::path path =
      fs::path(testing::TempDir()) / ("mocapress-rewritten-" + std::to_string(getpid()) + ".bvh");
  write_motion(path, file.motion, {}, file.source, writing);
  std::string written = read_text(path);
  fs::remove(path);
  return written;
}

/// The small file, of equal height in inches, with its root at its OFFSET.
std::string in_inches() {
  std::string text = test::kSmallBvh;
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"0 90 0", "0 30 0"},
                                                        {"0 40 0", "0 15 0"},
                                                        {"0 60 0", "0 21 0"},
                                                        {"1 2 3 10", "1 30 3 10"}})
    text = test::replaced(text, from, to);
  return text;
}

TEST_F(MotionFiles, InInchesStayInInches) {
  const std::string text = rewritten(in_inches(), {.cm_per_unit = 2.54});
  for (const char* line : {"OFFSET 0 30 0\n", "OFFSET 0 15 0\n", "OFFSET 0 21 0\n",
                           "\n1 30 3 10 20 30 1 2 3\n", "\nFrame Time: 0.0083333333\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST_F(MotionFiles, AreAsAskedForWhereTheirSourceWasNot) {
  const std::string text = rewritten(in_inches(), {.cm_per_unit = 2.54},
                                     {.sample_rate_hz = 60.0,
                                      .cm_per_unit = 1.0,
                                      .up = UpAxis::Z,
                                      .bvh_root = TranslationConvention::Adds});
  for (const char* line : {"OFFSET 0 0 76.2\n", "OFFSET 0 0 38.1\n", "OFFSET 0 0 53.34\n",
                           "\n2.54 -7.62 0 -10 20 30 ", "\nFrame Time: 0.0166666667\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
}

TEST_F(MotionFiles, WithZUpComeBackWithZUp) {
  const std::string again =
      rewritten(test::kSmallBvh, {.up = UpAxis::Z, .bvh_root = TranslationConvention::Replaces});
  for (const char* line :
       {"OFFSET 0 90 0\n", "OFFSET 0 40 0\n", "OFFSET 0 60 0\n", "Zrotation Yrotation Xrotation",
        "Xrotation Yrotation Zrotation", "\n1 2 3 10 20 30 1 2 3\n"})
    EXPECT_NE(again.find(line), std::string::npos) << line << again;
}

TEST_F(MotionFiles, AcclaimFilesKeepTheirUnit) {
  write_text(folder_ / "a.asf", test::replaced(test::kSmallAsf, "length 0.45", "length 1"));
  write_text(folder_ / "a.amc", test::kSmallAmc);
  const MotionFile file = read_motion(folder_ / "a.amc");
  EXPECT_EQ(file.source, (SourceFormat{.kind = SourceFormat::Kind::Acclaim, .cm_per_unit = 2.54}));
  write_motion(folder_ / "b.amc", file.motion, {}, file.source);
  EXPECT_NE(read_text(folder_ / "b.asf").find("length 1\n"), std::string::npos);
  EXPECT_NE(read_text(folder_ / "b.amc").find("root 1 2 3 10 20 30\n"), std::string::npos);
  write_motion(folder_ / "c.bvh", file.motion, {}, file.source);
  EXPECT_EQ(read_motion(folder_ / "c.bvh", {}, {.sample_rate_hz = {}, .cm_per_unit = 1.0})
                .motion.skeleton.joint(1)
                .offset,
            file.motion.skeleton.joint(1).offset);
  write_motion(folder_ / "d.amc", file.motion, {}, file.source,
               {.sample_rate_hz = {}, .cm_per_unit = kAsfCmPerUnit});
  EXPECT_NE(read_text(folder_ / "d.asf").find("length 0.45\n"), std::string::npos);
}

}  // namespace
}  // namespace mocapress::motion_file_test
