// SPDX-License-Identifier: MIT
#include "core/report/blind_test_record.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress::blind_test_record_test {
namespace {

/// Answers of a model observer (no person was asked) with this threshold.
BlindTestRecord record(Cue cue, double threshold, std::uint64_t seed = 1) {
  BlindTestRecord made{.viewer = "Ana",
                       .clip = "walk.bvh",
                       .character = "",
                       .time = "2026-11-28T02:00:00Z",
                       .cue = cue,
                       .limits = {},
                       .levels = {0.5, 1, 2, 4, 8},
                       .answers = {}};
  BlindTest test(made.levels, seed, 200);
  Random draws(seed + 77);
  const PsychometricCurve viewer{threshold, 5};
  while (!test.finished()) {
    const BlindTest::Question question = test.question();
    const bool right =
        draws.unit() < viewer.right(made.levels[static_cast<std::size_t>(question.level)]);
    test.answer(right == question.x_is_b);
  }
  made.answers.assign(test.answers().begin(), test.answers().end());
  return made;
}

class BlindTestRecordTest : public testing::Test {
 protected:
  BlindTestRecordTest() { std::filesystem::create_directories(folder_); }
  ~BlindTestRecordTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("mocapress-blind-test-" + std::to_string(getpid()));
  std::filesystem::path file_ = folder_ / "blind_tests.json";
};

TEST_F(BlindTestRecordTest, RecordsAreKeptOneAfterTheOther) {
  EXPECT_TRUE(read_blind_tests(file_).empty());
  const BlindTestRecord first = record(Cue::Velocity, 1.5);
  BlindTestRecord second = record(Cue::Hand, 2);
  second.limits.distance_m = 2.5;
  add_blind_test(file_, first);
  add_blind_test(file_, second);
  const std::vector<BlindTestRecord> read = read_blind_tests(file_);
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].answers, first.answers);
  EXPECT_EQ(read[0].viewer, "Ana");
  EXPECT_EQ(read[1].cue, Cue::Hand);
  EXPECT_EQ(read[1].limits, second.limits);
  EXPECT_EQ(read[1].levels, second.levels);
}

TEST_F(BlindTestRecordTest, BadFilesAreRefusedAndLeftAlone) {
  for (const char* text : {"{}", "[1]", "[{}]", "[{\"viewer\": 1}]", "["}) {
    write_text(file_, text);
    EXPECT_THROW(read_blind_tests(file_), InputError) << text;
    EXPECT_THROW(add_blind_test(file_, record(Cue::Place, 1)), InputError);
    EXPECT_EQ(read_text(file_), text);
  }
}

TEST_F(BlindTestRecordTest, TestedLimitsAreTheViewersAndOthersStay) {
  const SightLimits built_in;
  const SightLimits limits =
      limits_by({record(Cue::Velocity, 1.5, 1), record(Cue::Velocity, 1.5, 2)}, built_in);
  EXPECT_NEAR(limits.of(Cue::Velocity).least, 1.5 * built_in.of(Cue::Velocity).least, 0.5);
  EXPECT_NEAR(limits.of(Cue::Velocity).share / built_in.of(Cue::Velocity).share,
              limits.of(Cue::Velocity).least / built_in.of(Cue::Velocity).least, 1e-9);
  EXPECT_EQ(limits.of(Cue::Head), built_in.of(Cue::Head));
  EXPECT_EQ(limits.distance_m, built_in.distance_m);
}

TEST_F(BlindTestRecordTest, ThresholdsThatWereNotFoundChangeNothing) {
  EXPECT_EQ(limits_by({record(Cue::Slide, 1e9)}, {}), SightLimits());
}

}  // namespace
}  // namespace mocapress::blind_test_record_test
