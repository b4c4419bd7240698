// SPDX-License-Identifier: MIT
// Runs batches as a process: files, reports, exit codes, signals and kills.
#include <gmock/gmock.h>
#include <signal.h>

#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "core/base/file.h"
#include "tests/system/command.h"
#include "tests/system/running.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class CliBatch : public CommandLine {
 protected:
  void write_clips(int count) const { write_sample_clips(file("in"), count); }

  std::vector<std::string> batch(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> words = {"batch", file("in").string(), "-o", file(out).string()};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  json report(const std::string& out) const {
    return json::parse(read_text(file(out) / "report.json"));
  }

  std::map<std::string, std::string> contents(const std::string& out) const {
    return batch_contents(file(out));
  }

  static std::vector<json> lines(const std::string& text) {
    std::vector<json> all;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) all.push_back(json::parse(line));
    return all;
  }
};

TEST_F(CliBatch, VerifiesFifteenClipsWithTheSameBytesOnOneThreadAndTwo) {
  write_clips(15);
  const Outcome two = mocapress(batch("two", {"--jobs", "2", "--json-progress"}));
  ASSERT_EQ(two.exit_code, 0) << two.err;
  EXPECT_EQ(two.err, "");
  ASSERT_EQ(mocapress(batch("one", {"--jobs", "1"})).exit_code, 0);
  EXPECT_EQ(contents("one"), contents("two"));
  const json rows = report("two");
  ASSERT_EQ(rows.size(), 15u);
  for (const json& row : rows) {
    EXPECT_TRUE(row["done"]) << row;
    EXPECT_LE(row["eps_x_cm"], 0.5);
    const std::string made = file("two") / row["files"][0].get<std::string>();
    const json measured = json_of({"measure", row["input"], made, "--json"});
    for (const char* key : {"eps_x_cm", "max_error_cm", "motion_bytes", "ratio"})
      EXPECT_NEAR(measured[key].get<double>(), row[key].get<double>(),
                  1e-12 * row[key].get<double>())
          << key;
  }
  const std::vector<json> told = lines(two.out);
  EXPECT_EQ(told.front()["event"], "begin");
  EXPECT_EQ(told.back()["event"], "end");
  EXPECT_EQ(std::count_if(told.begin(), told.end(),
                          [](const json& line) { return line["event"] == "clip-done"; }),
            15);
}

TEST_F(CliBatch, KilledAnywhereAndResumedIsTheSameBytesAsUndisturbed) {
  write_clips(8);
  ASSERT_EQ(mocapress(batch("whole", {"--max-error", "0.3"})).exit_code, 0);
  const auto undisturbed = contents("whole");
  int kills = 0;
  std::optional<int> code;
  for (int run = 0; run < 60; ++run) {
    Running running(
        [&] {
          auto words = batch("killed", {"--max-error", "0.3", "--resume", "--json-progress"});
          words.insert(words.begin(), MOCAPRESS_EXECUTABLE);
          return words;
        }(),
        file("progress"));
    if (kills < 6) {
      // The kill comes after some progress, a little later each time.
      const std::size_t progress = 600 + 100 * static_cast<std::size_t>(kills);
      ASSERT_TRUE(comes_true(
          [&] { return fs::file_size(file("progress")) >= progress || running.ended(); }));
      running.send(SIGKILL);
    }
    code = running.wait();
    kills += code == -SIGKILL;
    if (code == 0) break;
  }
  EXPECT_EQ(code, 0);
  EXPECT_GE(kills, 2);
  EXPECT_EQ(contents("killed"), undisturbed);
}

TEST_F(CliBatch, AskedToTerminateLeavesWhatCanBeResumed) {
  write_clips(6);
  auto words = batch("out", {"--max-error", "0.1", "--jobs", "1", "--json-progress"});
  words.insert(words.begin(), MOCAPRESS_EXECUTABLE);
  Running running(words, file("progress"));
  ASSERT_TRUE(comes_true(
      [&] { return read_text(file("progress")).find("clip-done") != std::string::npos; }));
  running.send(SIGTERM);
  EXPECT_EQ(running.wait(), 128 + SIGTERM);
  EXPECT_EQ(lines(read_text(file("progress"))).back()["event"], "stopped");
  EXPECT_FALSE(fs::exists(file("out") / "report.html"));
  const Outcome resumed =
      mocapress(batch("out", {"--max-error", "0.1", "--resume", "--json-progress"}));
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_GE(lines(resumed.out).back()["batch"]["kept"], 1);
  EXPECT_EQ(report("out").size(), 6u);
}

TEST_F(CliBatch, ABadFileGetsARowAndExitCodeSeven) {
  write_clips(3);
  write_text(file("in") / "broken.bvh", "HIERARCHY\nnonsense\n");
  auto words = batch("out", {"--json-progress"});
  words.insert(words.begin() + 1, file("missing.bvh").string());
  const Outcome outcome = mocapress(words);
  EXPECT_EQ(outcome.exit_code, 7);
  const json rows = report("out");
  ASSERT_EQ(rows.size(), 5u);
  EXPECT_THAT(rows[0]["error"].get<std::string>(), HasSubstr("No such file"));
  EXPECT_THAT(rows[1]["error"].get<std::string>(), HasSubstr("broken.bvh:2"));
  for (std::size_t i = 2; i < 5; ++i) EXPECT_TRUE(rows[i]["error"].is_null()) << rows[i];
  write_clips(4);  // mended files and new ones are done, and nothing else
  fs::remove(file("in") / "broken.bvh");
  const Outcome mended = mocapress(batch("out", {"--resume", "--json-progress"}));
  EXPECT_EQ(mended.exit_code, 0);
  EXPECT_EQ(lines(mended.out).back()["batch"]["kept"], 3);
}

TEST_F(CliBatch, LeavesItsOutputsInsideTheInputOutOfIt) {
  write_clips(2);
  for (int run = 0; run < 3; ++run) {
    const Outcome outcome = mocapress(batch("in/out", {"--format", "bvh", "--resume"}));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(report("in/out").size(), 2u);
  }
  EXPECT_EQ(mocapress(batch("in", {"--format", "bvh"})).exit_code, 2) << "no folder of its own";
}

TEST_F(CliBatch, ALeftOutClipIsARowAndExitCodeSeven) {
  write_clips(1);
  write_text(file("in") / "..bvh", test_bvh());
  fs::create_symlink("gone.bvh", file("in") / "dangling.bvh");
  EXPECT_EQ(mocapress(batch("out")).exit_code, 7);
  const json rows = report("out");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_THAT(rows[0]["error"].get<std::string>(), HasSubstr("its output's name"));
  EXPECT_TRUE(rows[1]["done"]);
  EXPECT_THAT(rows[2]["error"].get<std::string>(), HasSubstr("leads nowhere"));
}

TEST_F(CliBatch, FailsOnWhatItIsToldToWithCompleteReports) {
  write_clips(1);
  EXPECT_EQ(mocapress(batch("fine", {"--fail-on", "visible,borderline", "--target-error", "0.001"}))
                .exit_code,
            0);
  const Outcome coarse = mocapress(batch("out", {"--fail-on", "visible", "--target-error", "20"}));
  EXPECT_EQ(coarse.exit_code, 4);
  EXPECT_THAT(coarse.err, testing::ContainsRegex(
                              "--fail-on refuses 1 clip\n  .*\\.bvh: visible: .* noticed from"));
  EXPECT_TRUE(report("out")[0]["done"]);
  EXPECT_EQ(mocapress({"batch", "--merge", file("out"), "--fail-on", "visible"}).exit_code, 4);
  EXPECT_EQ(mocapress(batch("out", {"--fail-on", "ugly"})).exit_code, 2);
}

TEST_F(CliBatch, TellsWhatChangedSinceAnEarlierOne) {
  write_clips(2);
  mocapress(batch("old", {"--target-error", "0.1"}));
  mocapress(batch("new", {"--target-error", "20"}));
  const std::vector<std::string> both = {"diff", file("old"), file("new")};
  const auto diff = [&](std::vector<std::string> more) {
    more.insert(more.begin(), both.begin(), both.end());
    return mocapress(more);
  };
  const json found = json::parse(diff({"--json"}).out);
  EXPECT_EQ(found["clips"], 2);
  EXPECT_EQ(found["counts"]["worse"], 2);
  EXPECT_EQ(found["counts"]["smaller"], 2);
  EXPECT_EQ(found["counts"]["larger"], 0);
  EXPECT_THAT(diff({}).out, HasSubstr("2 worse"));
  EXPECT_EQ(diff({"--fail-on", "larger,failed"}).exit_code, 0);
  EXPECT_EQ(diff({"--fail-on", "larger,worse"}).exit_code, 4);
  EXPECT_EQ(diff({"--fail-on", "ugly"}).exit_code, 2);
  EXPECT_EQ(mocapress({"diff", file("old"), file("old"), "--fail-on", "worse"}).exit_code, 0);
  EXPECT_EQ(mocapress({"diff", file("old"), file("nowhere")}).exit_code, 3);
}

TEST_F(CliBatch, ADifferenceOfVisibilityFromOtherDistancesIsNotPassed) {
  write_clips(1);
  mocapress(batch("far", {"--target-error", "1", "--distance", "40"}));
  mocapress(batch("near", {"--target-error", "1", "--distance", "1"}));
  const Outcome silent = mocapress({"diff", file("far"), file("near"), "--fail-on", "worse"});
  EXPECT_EQ(silent.exit_code, 0);
  EXPECT_THAT(silent.err, HasSubstr("1 clip judged from another distance"));
  EXPECT_EQ(mocapress({"diff", file("far"), file("near"), "--fail-on", "newly-visible"}).exit_code,
            4);
}

TEST_F(CliBatch, ADifferenceFromABatchThatWasCutOffIsNotPassed) {
  write_clips(2);
  mocapress(batch("old", {"--target-error", "1"}));
  mocapress(batch("new", {"--target-error", "1"}));
  std::string journal = read_text(file("new/batch.jsonl"));
  journal.resize(journal.find('\n') + 1);
  write("new/batch.jsonl", journal);
  const Outcome cut = mocapress({"diff", file("old"), file("new"), "--fail-on", "failed,worse"});
  EXPECT_EQ(cut.exit_code, 7);
  EXPECT_THAT(cut.err, HasSubstr("2 clips without a row: the batch was not finished"));
  EXPECT_EQ(mocapress({"diff", file("new"), file("old")}).exit_code, 0);
}

TEST_F(CliBatch, SignsOffWhatAProjectsReviewersSaid) {
  write_clips(2);
  const std::string project = write("hero.mocapress", R"({"format": "mocapress-project",
    "version": 1, "clips": [{"path": "in/clip_100.bvh"},
                            {"path": "in/clip_101.bvh", "verdict": "approved", "reviewer": "ann"}]})");
  mocapress({"batch", project, "-o", file("out"), "--preset", "crowd"});
  const Outcome done = mocapress({"signoff", file("out"), "-o", file("sign-off.csv")});
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_THAT(done.out, HasSubstr("2 clips: 0 approved, 0 rejected, 1 stale, 1 without a verdict"));
  const std::string table = read_text(file("sign-off.csv"));
  EXPECT_THAT(table, HasSubstr(",approved,ann,"));
  EXPECT_THAT(table, HasSubstr(" from 40 m"));  // the preset's distance
  EXPECT_EQ(
      mocapress({"signoff", file("out"), "-o", file("sign-off.html"), "--all-approved"}).exit_code,
      4);
  EXPECT_THAT(read_text(file("sign-off.html")), HasSubstr("clip_101.bvh"));
  EXPECT_EQ(mocapress({"signoff", file("out"), "-o", file("sign-off.pdf")}).exit_code, 2);
  EXPECT_EQ(mocapress({"signoff", file("nowhere"), "-o", file("a.csv")}).exit_code, 3);
}

TEST_F(CliBatch, ASignOffReplacesNoFileOfItsBatch) {
  write_clips(1);
  mocapress(batch("out", {"--target-error", "1", "--format", "mcpr,csv"}));
  for (const std::string name :
       {"report.csv", "report.html", "report-1-of-2.csv", "in/clip_100.csv"}) {
    const std::string own = file("out/" + name);
    const bool was_there = std::filesystem::exists(own);
    const std::string before = was_there ? read_text(own) : "";
    const Outcome refused = mocapress({"signoff", file("out"), "-o", own});
    EXPECT_EQ(refused.exit_code, 5) << name;
    EXPECT_THAT(refused.err, HasSubstr("not overwritten"));
    EXPECT_EQ(std::filesystem::exists(own), was_there);
    EXPECT_EQ(was_there ? read_text(own) : "", before);
  }
  const std::string linked = file("link.html");
  std::filesystem::create_symlink(file("out/report.html"), linked);
  const std::string page = read_text(file("out/report.html"));
  EXPECT_EQ(mocapress({"signoff", file("out"), "-o", linked}).exit_code, 5);
  EXPECT_EQ(read_text(file("out/report.html")), page);
  EXPECT_EQ(mocapress({"signoff", file("out"), "-o", file("out/sign-off.csv")}).exit_code, 0);
  EXPECT_EQ(mocapress({"signoff", file("out"), "-o", file("out/sign-off.csv")}).exit_code, 0);
}

TEST_F(CliBatch, DoesAProjectOfTheStudio) {
  write_clips(2);
  const std::string project = write("hero.mocapress", R"({"format": "mocapress-project",
    "version": 1, "clips": [
    {"path": "in/clip_100.bvh", "verdict": "approved",
     "settings": {"name": "Mine", "target": {"kind": "error", "value": 2}}},
    {"path": "in/gone.bvh"}]})");
  EXPECT_EQ(mocapress({"batch", project, "-o", file("out"), "--preset", "crowd"}).exit_code, 7);
  const json rows = report("out");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0]["preset"], "Mine");
  EXPECT_EQ(rows[0]["target_value"], 2);
  EXPECT_EQ(rows[0]["verdict"], "approved");
  EXPECT_FALSE(rows[0]["stale"].is_null()) << "nothing says what was approved";
  EXPECT_EQ(rows[1]["preset"], "Crowd");
  EXPECT_FALSE(rows[1]["done"]);
}

TEST_F(CliBatch, OverwritesNothingUnasked) {
  write_clips(2);
  fs::create_directories(file("out") / "in");
  write_text(file("out/in/clip_100.mcpr"), "mine");
  EXPECT_EQ(mocapress(batch("out")).exit_code, 7);
  EXPECT_EQ(read_text(file("out/in/clip_100.mcpr")), "mine");
  EXPECT_EQ(mocapress(batch("out")).exit_code, 5) << "there is a batch already";
  EXPECT_EQ(mocapress(batch("out", {"--overwrite"})).exit_code, 0);
  EXPECT_NE(read_text(file("out/in/clip_100.mcpr")), "mine");
}

TEST_F(CliBatch, WritesTheFormatsAndNamesAskedFor) {
  write_clips(1);
  const Outcome outcome = mocapress(batch(
      "out", {"--format", "mcpr,bvh,amc,csv", "--name", "{stem}_{preset}", "--preset", "crowd"}));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* extension : {"mcpr", "bvh", "asf", "amc", "csv"})
    EXPECT_TRUE(fs::exists(file("out") / ("clip_100_crowd." + std::string(extension))));
  const Outcome info = mocapress({"info", file("out/clip_100_crowd.amc").string()});
  EXPECT_EQ(info.exit_code, 0) << info.err;
}

TEST_F(CliBatch, PutsItsFilesIntoABank) {
  write_clips(2);
  const Outcome made = mocapress(batch("out", {"--bank", "packed", "--json-progress"}));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr(R"("event":"bank-step")"));
  EXPECT_THAT(made.out, HasSubstr("bank.mcpk"));
  const Outcome listed = mocapress({"bank", "list", file("out/bank.mcpk"), "--json"});
  EXPECT_THAT(listed.out, HasSubstr(R"("name": "in/clip_100")"));
  const Outcome cooked = mocapress(batch("out", {"--bank", "cooked", "--resume"}));
  ASSERT_EQ(cooked.exit_code, 0) << cooked.err;
  EXPECT_THAT(cooked.err, HasSubstr("2 of 2 clips done, 2 of them by an earlier run"));
  EXPECT_THAT(mocapress({"bank", "list", file("out/bank.mcpk"), "--json"}).out,
              HasSubstr(R"("form": "cooked")"));
}

TEST_F(CliBatch, LearnsFromTheClipsOfItsBank) {
  write_clips(2);
  ASSERT_EQ(mocapress(batch("out", {"--bank", "packed"})).exit_code, 0);
  const auto plain = read_bytes(file("out/bank.mcpk"));
  const Outcome learned = mocapress(batch("out", {"--bank", "packed", "--learn", "--resume"}));
  ASSERT_EQ(learned.exit_code, 0) << learned.err;
  EXPECT_EQ(read_bytes(file("out/bank.mcpk")), plain);  // two clips give no priors that pay off
}

TEST_F(CliBatch, MeasuresOnTheSkinOfACharacterThatFits) {
  const fs::path samples = fs::path(MOCAPRESS_SOURCE_DIR) / "resources/samples";
  fs::create_directories(file("in"));
  for (const char* name : {"human.asf", "human_walk.amc"})
    write("in/" + std::string(name), read_text(samples / name));
  const std::string hero = read_text(samples / "character.glb");
  std::vector<std::string> more = {"--character", write("hero.glb", hero), "--weighting",
                                   "skin",        "--target-error",        "0.3"};
  const Outcome made = mocapress(batch("out", more));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  ASSERT_EQ(report("out").size(), 1u);
  EXPECT_LE(report("out")[0]["skin_rms_cm"], 0.3);
  EXPECT_GT(report("out")[0]["skin_rms_cm"], 0.1);
  const Outcome bare = mocapress(batch("bare", {"--weighting", "skin", "--target-error", "0.3"}));
  EXPECT_EQ(bare.exit_code, 7);
  // Rows measured on a character that was edited since are done again.
  more.insert(more.end(), {"--resume", "--overwrite"});
  EXPECT_THAT(mocapress(batch("out", more)).err, HasSubstr("1 of them by an earlier run"));
  write("hero.glb", hero + '\0');
  EXPECT_THAT(mocapress(batch("out", more)).err,
              testing::Not(HasSubstr("of them by an earlier run")));
  // A different character makes a different batch.
  const Outcome other =
      mocapress(batch("out", {"--target-error", "0.3", "--resume", "--overwrite"}));
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_THAT(other.err, testing::Not(HasSubstr("of them by an earlier run")));
}

TEST_F(CliBatch, KeepsTheCurvesBesideAClip) {
  write_clips(2);
  ASSERT_EQ(mocapress(batch("out")).exit_code, 0);
  write("in/clip_100.tracks.csv", "step\n0\n");
  const Outcome refused = mocapress(batch("out", {"--resume", "--overwrite"}));
  EXPECT_EQ(refused.exit_code, 7);
  EXPECT_THAT(report("out")[0]["error"].get<std::string>(), HasSubstr("clip_100.tracks.csv:2:1"));
  std::string table = "step\n";
  for (int frame = 0; frame < 90; ++frame) table += frame % 20 < 5 ? "1\n" : "0\n";
  write("in/clip_100.tracks.csv", table);
  const Outcome made = mocapress(batch("out", {"--resume", "--overwrite"}));
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_THAT(made.err, HasSubstr("1 of them by an earlier run"));
  const Outcome info = mocapress({"info", file("out/in/clip_100.mcpr"), "--json"});
  EXPECT_EQ(json::parse(info.out)[0]["tracks"][0]["name"], "step");
}

TEST_F(CliBatch, ShardsAndTheirMergeAreAsOneRun) {
  write_clips(6);
  ASSERT_EQ(mocapress(batch("whole")).exit_code, 0);
  for (const char* shard : {"2/3", "1/3"})
    ASSERT_EQ(mocapress(batch("parts", {"--shard", shard})).exit_code, 0);
  const std::string parts = file("parts").string();
  EXPECT_EQ(mocapress({"batch", "--merge", parts}).exit_code, 7) << "a shard is missing";
  ASSERT_EQ(mocapress(batch("parts", {"--shard", "3/3"})).exit_code, 0);
  EXPECT_EQ(mocapress({"batch", "--merge", parts}).exit_code, 0);
  const auto together = contents("parts");
  for (const auto& [name, text] : contents("whole")) EXPECT_EQ(together.at(name), text) << name;
}

TEST_F(CliBatch, OwnPresetsAreReadAndWrongOnesRefused) {
  write_clips(1);
  const std::string preset =
      write("mine.json", R"({"name": "Mine", "target": {"kind": "max-error", "value": 1.5}})");
  ASSERT_EQ(mocapress(batch("out", {"--preset", preset})).exit_code, 0);
  EXPECT_EQ(report("out")[0]["preset"], "Mine");
  EXPECT_LE(report("out")[0]["surface_max_cm"], 1.5);
  const std::string wrong = write("wrong.json", R"({"name": "Mine", "tarket": 3})");
  const Outcome refused = mocapress(batch("other", {"--preset", wrong}));
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_THAT(refused.err, HasSubstr("tarket"));
}

TEST_F(CliBatch, WrongUseExitsWithTwoAndMissingInputWithThree) {
  write_clips(1);
  EXPECT_EQ(mocapress({"batch"}).exit_code, 2);
  EXPECT_EQ(mocapress({"batch", file("in")}).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--shard", "3/2"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--format", "exe"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--name", "{nothing}"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--bank", "raw"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--bank", "packed", "--format", "bvh"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--learn"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--bank", "cooked", "--learn"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--bank", "packed", "--shard", "1/2"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--coding", "deflate"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--ratio", "2", "--max-error", "1"})).exit_code, 2);
  EXPECT_EQ(mocapress(batch("out", {"--preset", "nothing"})).exit_code, 3);
  EXPECT_EQ(mocapress({"batch", file("none"), "-o", file("out")}).exit_code, 3);
  EXPECT_EQ(mocapress({"batch", "--merge", file("in")}).exit_code, 3);
  const std::string occupied = write("occupied", "");
  EXPECT_EQ(mocapress({"batch", file("in"), "-o", occupied}).exit_code, 5);
}

}  // namespace
}  // namespace mocapress::test
