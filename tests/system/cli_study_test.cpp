// SPDX-License-Identifier: MIT
// Runs studies as a process: one command, its files, stopping and resuming.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "core/base/file.h"
#include "tests/system/command.h"

namespace mocapress::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class CliStudy : public CommandLine {
 protected:
  /// The three Acclaim clips, without the character.
  CliStudy() {
    std::filesystem::create_directories(samples_);
    for (const char* name : {"human.asf", "human_walk.amc", "human_run.amc", "human_jump.amc"})
      write_text(samples_ / name, read_text(std::filesystem::path(MOCAPRESS_SOURCE_DIR) /
                                            "resources/samples" / name));
  }

  std::vector<std::string> study(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {
        "study",    samples_.string(), "--methods", "standard,per-channel",
        "--ratios", "10,40",           "-o",        file("out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  json rows() const { return json::parse(read_text(file("out") / "rows.json")); }

  const std::filesystem::path samples_ = file("samples");
};

TEST_F(CliStudy, WritesTablesAndAReportForAFolder) {
  const Outcome outcome = mocapress(study());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("report.html"));
  const json all = rows();
  ASSERT_EQ(all.size(), 3u * 2u * 2u);
  for (const json& row : all) {
    EXPECT_TRUE(row["reached"]) << row;
    EXPECT_NEAR(row["ratio"].get<double>() / row["target_value"].get<double>(), 1, 0.0201);
    EXPECT_GT(row["contacts"], 0) << row;
    EXPECT_TRUE(row["footskate_cm"].is_number()) << row;
  }
  const std::string csv = read_text(file("out") / "rows.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 12);
  EXPECT_THAT(read_text(file("out") / "report.html"), HasSubstr("human_jump"));
}

TEST_F(CliStudy, MeasuresOnTheSkinOfACharacter) {
  const auto character =
      std::filesystem::path(MOCAPRESS_SOURCE_DIR) / "resources/samples/character.glb";
  const Outcome outcome = mocapress(study({"--character", character, "--weighting", "skin"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = rows();
  ASSERT_EQ(all.size(), 3u * 2u * 2u);
  for (const json& row : all) EXPECT_GT(row["skin_rms_cm"], 0) << row;
}

TEST_F(CliStudy, RunAgainKeepsWhatIsThere) {
  ASSERT_EQ(mocapress(study()).exit_code, 0);
  const std::string first = read_text(file("out") / "rows.csv");
  const Outcome again = mocapress(study());
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.err, HasSubstr("12 of them made by an earlier run"));
  EXPECT_EQ(read_text(file("out") / "rows.csv"), first);
}

TEST_F(CliStudy, StoppedByASignalGoesOnWithTheSameCommand) {
  const std::string lines = "'" + file("lines").string() + "'";
  std::string command = "'" MOCAPRESS_EXECUTABLE "'";
  for (const std::string& word : study({"--json-progress", "--jobs", "1"}))
    command += " '" + word + "'";
  // The signal comes as soon as two rows are done.
  const Outcome stopped =
      run_program({"bash", "-c",
                   ": > " + lines + "; " + command + " > " + lines +
                       " & pid=$!; while kill -0 $pid && [ \"$(wc -l < " + lines +
                       ")\" -lt 2 ]; do :; done; kill -INT $pid; wait $pid"});
  if (stopped.exit_code == 0) GTEST_SKIP() << "the study was over before the signal came";
  EXPECT_EQ(stopped.exit_code, 128 + 2) << stopped.err;
  EXPECT_THAT(stopped.err, HasSubstr("to continue, run the same command"));
  EXPECT_FALSE(std::filesystem::exists(file("out") / "report.html"));
  const Outcome outcome = mocapress(study());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr(" 0 of them made by an earlier run")));
  EXPECT_EQ(rows().size(), 12u);
}

TEST_F(CliStudy, PrintsEachRowAsALineOfJsonWhenAsked) {
  const Outcome outcome = mocapress(study({"--json-progress"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_TRUE(json::parse(line).contains("eps_x_cm")) << line;
  EXPECT_EQ(count, 12);
}

TEST_F(CliStudy, ClipsThatCannotBeReadAreSevenAfterTheOthersAreDone) {
  write("broken.bvh", "nonsense");
  write("walk.bvh", test_bvh());
  const Outcome outcome = mocapress({"study", file("broken.bvh"), file("walk.bvh"), "--methods",
                                     "standard", "--errors", "1,1e-9", "-o", file("out")});
  EXPECT_EQ(outcome.exit_code, 7) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("broken.bvh"));
  const json all = rows();
  ASSERT_EQ(all.size(), 4u);
  EXPECT_TRUE(all[0]["error"].is_string());
  EXPECT_LE(all[2]["eps_x_cm"], 1);
  EXPECT_THAT(all[3]["error"].get<std::string>(), HasSubstr("out of reach"));
}

TEST_F(CliStudy, WrongUseIsTwoAndAMissingInputThree) {
  EXPECT_EQ(mocapress({"study"}).exit_code, 2);
  EXPECT_EQ(mocapress({"study", samples_}).exit_code, 2);
  EXPECT_EQ(mocapress(study({"--errors", "many"})).exit_code, 2);
  EXPECT_EQ(mocapress({"study", samples_, "--methods", "magic", "-o", file("out")}).exit_code, 2);
  EXPECT_EQ(mocapress({"study", file("none"), "-o", file("out")}).exit_code, 3);
  const std::string occupied = write("occupied", "");
  EXPECT_EQ(mocapress({"study", samples_, "-o", occupied, "--methods", "standard"}).exit_code, 5);
}

}  // namespace
}  // namespace mocapress::test
