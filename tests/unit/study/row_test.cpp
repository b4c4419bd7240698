// SPDX-License-Identifier: MIT
#include "core/study/row.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/base/file.h"
#include "core/report/loaded_clip.h"
#include "tests/support/test_motion.h"
#include "tests/unit/study/study_rows.h"

namespace mocapress {
namespace {

using test::full_row;
using test::point;

/// A test with a file of its own.
class RowsFileTest : public testing::Test {
 protected:
  RowsFileTest() { std::filesystem::remove(path_); }
  ~RowsFileTest() override { std::filesystem::remove(path_); }

  const std::filesystem::path path_ =
      std::filesystem::path(testing::TempDir()) / ("rows-" + std::to_string(getpid()) + ".jsonl");
};

TEST(StudyRow, SurvivesALineOfJson) {
  StudyRow row = full_row();
  row.review = {Verdict::Rejected, "slides, left"};
  const auto again = parse_row(to_json_line(row));
  ASSERT_TRUE(again);
  EXPECT_EQ(again->clip, row.clip);
  EXPECT_EQ(again->review, row.review);
  EXPECT_EQ(again->key(), row.key());
  EXPECT_EQ(again->jobs, row.jobs);
  EXPECT_EQ(again->measured, row.measured);
  EXPECT_EQ(to_json_line(*again), to_json_line(row));
}

TEST(StudyRow, WithoutAMeasurementSurvivesToo) {
  StudyRow row{.clip = "x.bvh", .fingerprint = "", .settings = {.method = "pca"}};
  row.error = "x.bvh: line\nbreak, \xff and \"quotes\"";
  const auto again = parse_row(to_json_line(row));
  ASSERT_TRUE(again);
  EXPECT_FALSE(again->measured);
  EXPECT_FALSE(coding_of(again->settings));
  EXPECT_NE(again->error.find("line\nbreak"), std::string::npos);
}

TEST(StudyRow, IsNotReadFromAnythingElse) {
  const std::string line = to_json_line(full_row());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, line.size() / 2, line.size() - 1})
    EXPECT_FALSE(parse_row(line.substr(0, length))) << length;
  for (const char* text : {"[]", "{}", "null", "{\"clip\": 3}"}) EXPECT_FALSE(parse_row(text));
  std::string unknown = line;
  unknown.replace(unknown.find("rle16"), 5, "magic");
  EXPECT_FALSE(parse_row(unknown));
}

TEST(StudyRow, KeyTellsApartAllThatWasAskedAndTheMotion) {
  std::vector<StudyRow> rows(9, full_row());
  rows[1].fingerprint = "other";
  rows[2].settings.method = "standard";
  rows[3].settings.target.kind = Target::Kind::Ratio;
  rows[4].settings.target.value = 0.27;
  rows[5].settings.weighting = Weighting::BoneEnds;
  rows[6].settings.coding = Coding::Deflate;
  rows[7].settings.seed = 2;
  rows[8].settings.correction.reset();
  std::vector<std::string> keys;
  for (const StudyRow& row : rows) keys.push_back(row.key());
  std::sort(keys.begin(), keys.end());
  EXPECT_EQ(std::unique(keys.begin(), keys.end()), keys.end());

  StudyRow elsewhere = full_row();
  elsewhere.clip = "another/folder.bvh";
  elsewhere.jobs = 8;
  EXPECT_EQ(elsewhere.key(), full_row().key());
}

TEST(StudyRow, HasReachedARatioWithinTwoPercentAndABoundNotExceeded) {
  const Target ratio{Target::Kind::Ratio, 20};
  EXPECT_TRUE(point("a", "annealed", ratio, 20.39, 1).reached());
  EXPECT_FALSE(point("a", "annealed", ratio, 20.41, 1).reached());
  EXPECT_FALSE(point("a", "annealed", ratio, 19.59, 1).reached());
  const Target error{Target::Kind::Error, 0.5};
  EXPECT_TRUE(point("a", "annealed", error, 20, 0.5).reached());
  EXPECT_FALSE(point("a", "annealed", error, 20, 0.501).reached());
  StudyRow other_weighting = point("a", "annealed", error, 20, 0.6);
  other_weighting.settings.weighting = Weighting::JointOrigins;  // 0.8 of it
  EXPECT_TRUE(other_weighting.reached());
  EXPECT_FALSE(StudyRow{}.reached());
}

TEST(RowsCsv, HasAHeaderAndAsManyFieldsInEachLine) {
  StudyRow plain = full_row();
  plain.clip = "walk.bvh";
  StudyRow failed{.clip = "run.bvh", .settings = {.method = "pca"}, .error = "no such file"};
  const std::string text = rows_csv(std::vector{plain, failed});
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].substr(0, 24), "clip,fingerprint,method,");
  const auto commas = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',');
  };
  EXPECT_EQ(commas(lines[1]), commas(lines[0]));
  EXPECT_EQ(commas(lines[2]), commas(lines[0]));
}

TEST(RowsReports, SayWhichProgramMadeThemAndWhen) {
  const std::vector rows{full_row()};
  for (const std::string& text : {rows_csv(rows), rows_json(rows)}) {
    EXPECT_NE(text.find("Mocapress "), std::string::npos);
    EXPECT_NE(text.find("2023-11-14T22:13:20Z"), std::string::npos);  // time fixed by the tests
  }
}

TEST(RowsCsv, QuotesWhatNeedsIt) {
  EXPECT_NE(rows_csv(std::vector{full_row()}).find("\n\"clips/walk, \"\"slow\"\" <1>.bvh\","),
            std::string::npos);
}

TEST_F(RowsFileTest, GivesBackWhatWasAppended) {
  {
    RowsFile file(path_);
    EXPECT_TRUE(file.rows().empty());
    file.append(full_row());
    file.append(point("b", "pca", {}, 3, 1));
  }
  const RowsFile file(path_);
  ASSERT_EQ(file.rows().size(), 2u);
  EXPECT_EQ(file.rows()[0].measured, full_row().measured);
  EXPECT_EQ(file.rows()[1].settings.method, "pca");
}

TEST_F(RowsFileTest, DropsATornLastLineAndGoesOnAfterIt) {
  const std::string line = to_json_line(full_row());
  write_text(path_, line + "\n" + line.substr(0, line.size() / 2));
  {
    RowsFile file(path_);
    EXPECT_EQ(file.rows().size(), 1u);
    file.append(point("b", "pca", {}, 3, 1));
  }
  EXPECT_EQ(RowsFile(path_).rows().size(), 2u);
}

TEST(Fingerprint, ChangesWithEveryPartOfAMotionAndOnlyThen) {
  const Motion motion = test::smooth_motion(40);
  const std::string original = fingerprint(motion);
  EXPECT_EQ(original.size(), 16u);
  EXPECT_EQ(fingerprint(test::smooth_motion(40)), original);
  Motion changed = motion;
  changed.clip.channels(39, 2) += 1e-9;
  EXPECT_NE(fingerprint(changed), original);
  changed = motion;
  changed.clip.sample_rate_hz = 60;
  EXPECT_NE(fingerprint(changed), original);
  changed = motion;
  changed.skeleton.add({.name = "more", .parent = 0, .offset = {0, 1, 0}});
  EXPECT_NE(fingerprint(changed), original);
  changed = motion;
  changed.skeleton.set_skin(std::make_shared<const SkinPoints>(
      SkinPoints{{{.joint = 1, .in_joint = {1, 2, 3}, .weight = 1}}}));
  const std::string with_mesh = fingerprint(changed);
  EXPECT_NE(with_mesh, original);
  changed.skeleton.set_skin(std::make_shared<const SkinPoints>(
      SkinPoints{{{.joint = 1, .in_joint = {1, 2, 4}, .weight = 1}}}));
  EXPECT_NE(fingerprint(changed), with_mesh);
}

}  // namespace
}  // namespace mocapress
