// SPDX-License-Identifier: MIT
// Leftovers of commands that cannot write, and files that they must not touch.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/base/file.h"
#include "tests/system/command.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;

class CliWriting : public CommandLine {
 protected:
  /// Runs a command with files limited to 2 kB, as on a full disk.
  static Outcome cramped(const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {"sh", "-c", "trap '' XFSZ; ulimit -f 4; exec \"$@\"", "sh",
                                      MOCAPRESS_EXECUTABLE};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(words);
  }

  /// The names of all files below a folder.
  std::vector<std::string> names(const std::string& folder) const {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(file(folder)))
      all.push_back(entry.path().lexically_relative(file(folder)));
    std::sort(all.begin(), all.end());
    return all;
  }
};

TEST_F(CliWriting, AFileThatDoesNotFitIsFiveAndTheOldOneIsLeft) {
  fs::create_directories(file("out"));
  const std::string clip = write("walk.bvh", test_bvh());
  ASSERT_EQ(mocapress({"compress", clip, "-o", file("walk.mcpr")}).exit_code, 0);
  for (const char* name : {"out/a.mcpr", "out/a.bvh", "out/a.csv"}) write(name, "old");
  for (const auto& [command, source, name] : {std::tuple("compress", "walk.bvh", "out/a.mcpr"),
                                              std::tuple("decompress", "walk.mcpr", "out/a.bvh"),
                                              std::tuple("decompress", "walk.mcpr", "out/a.csv")}) {
    std::vector<std::string> words = {command, file(source), "-o", file(name)};
    if (command == std::string("compress")) words.insert(words.end(), {"--target-error", "0.001"});
    const Outcome outcome = cramped(words);
    EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(name + std::string(": cannot be written: File too large")));
    EXPECT_EQ(read_text(file(name)), "old");
  }
  EXPECT_EQ(names("out").size(), 3u);
}

TEST_F(CliWriting, ABatchThatDoesNotFitLeavesNoHalfFiles) {
  write_sample_clips(file("in"), 2);
  const Outcome outcome =
      cramped({"batch", file("in"), "-o", file("out"), "--format", "bvh", "--jobs", "1"});
  EXPECT_TRUE(outcome.exit_code == 5 || outcome.exit_code == 7) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("File too large"));
  EXPECT_THAT(names("out"),
              testing::Each(testing::AnyOf("in", "batch.jsonl", "report.csv", "report.json")));
  const Outcome resumed =
      mocapress({"batch", file("in"), "-o", file("out"), "--format", "bvh", "--resume"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(names("out"), Contains("in/clip_100.bvh"));
}

TEST_F(CliWriting, AStudyThatDoesNotFitKeepsTheOldReport) {
  write_sample_clips(file("in"), 1);
  fs::create_directories(file("out"));
  write("out/report.html", "old");
  const std::vector<std::string> study = {"study",     file("in"), "-o",       file("out"),
                                          "--methods", "standard", "--ratios", "10"};
  const Outcome outcome = cramped(study);
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_EQ(read_text(file("out/report.html")), "old");
  EXPECT_EQ(mocapress(study).exit_code, 0);
  EXPECT_NE(read_text(file("out/report.html")), "old");
  EXPECT_THAT(names("out"),
              testing::ElementsAre("report.html", "rows.csv", "rows.json", "rows.jsonl"));
}

TEST_F(CliWriting, LeavesOtherFilesAlone) {
  const std::string clip = write("walk.bvh", test_bvh());
  write("walk.mcpr.part", "the user's own");
  write("victim", "precious");
  fs::create_symlink("victim", file("other.mcpr.part"));
  for (const char* name : {"walk.mcpr", "other.mcpr"})
    EXPECT_EQ(mocapress({"compress", clip, "-o", file(name)}).exit_code, 0);
  EXPECT_EQ(read_text(file("walk.mcpr.part")), "the user's own");
  EXPECT_EQ(read_text(file("victim")), "precious");
  EXPECT_EQ(names(".").size(), 6u);
}

TEST_F(CliWriting, ALinkStaysAndWhatItPointsToIsWritten) {
  const std::string clip = write("walk.bvh", test_bvh());
  fs::create_directories(file("store"));
  fs::create_symlink("store/walk.mcpr", file("walk.mcpr"));
  ASSERT_EQ(mocapress({"compress", clip, "-o", file("walk.mcpr")}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(file("walk.mcpr")));
  EXPECT_EQ(mocapress({"info", file("store/walk.mcpr")}).exit_code, 0);
}

TEST_F(CliWriting, APipeIsNotReplaced) {
  const std::string clip = write("walk.bvh", test_bvh());
  ASSERT_EQ(mkfifo(file("pipe.mcpr").c_str(), 0600), 0);
  const Outcome outcome = mocapress({"compress", clip, "-o", file("pipe.mcpr")});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, HasSubstr("pipe.mcpr: cannot be written: is not a regular file"));
  EXPECT_TRUE(fs::is_fifo(file("pipe.mcpr")));
}

TEST_F(CliWriting, NoCommandWritesOntoItsSource) {
  const std::string clip = write("walk.bvh", test_bvh());
  ASSERT_EQ(mocapress({"compress", clip, "-o", file("walk.mcpr")}).exit_code, 0);
  const Outcome other_format = mocapress({"compress", clip, "-o", clip});
  EXPECT_EQ(other_format.exit_code, 2);
  EXPECT_THAT(other_format.err, HasSubstr("decompress writes motion files"));
  fs::create_hard_link(clip, file("hard.mcpr"));
  fs::create_symlink("walk.bvh", file("link.mcpr"));
  fs::copy_file(file("walk.mcpr"), file("odd.bvh"));
  for (const auto& words : {std::vector<std::string>{"compress", clip, "-o", file("hard.mcpr")},
                            {"compress", clip, "-o", file("link.mcpr")},
                            {"decompress", file("odd.bvh"), "-o", file("odd.bvh")},
                            {"contacts", clip, "-o", clip},
                            {"contacts", clip, file("walk.mcpr"), "-o", file("walk.mcpr")}}) {
    const Outcome outcome = mocapress(words);
    EXPECT_EQ(outcome.exit_code, 5) << words[0];
    EXPECT_THAT(outcome.err, HasSubstr("is one of the inputs: not overwritten"));
  }
  EXPECT_EQ(mocapress({"batch", clip, "-o", file("out"), "--write-slurm", clip}).exit_code, 5);
  ASSERT_EQ(mocapress({"bank", "make", file("walk.mcpk"), file("walk.mcpr")}).exit_code, 0);
  fs::create_directories(file("banks"));
  fs::rename(file("walk.mcpk"), file("banks/walk.mcpr"));
  EXPECT_EQ(
      mocapress({"bank", "extract", file("banks/walk.mcpr"), "-o", file("banks"), "--overwrite"})
          .exit_code,
      5);
  EXPECT_EQ(read_text(clip), test_bvh());
  EXPECT_EQ(read_bytes(file("odd.bvh")), read_bytes(file("walk.mcpr")));
}

TEST_F(CliWriting, DecompressSaysThatItReplacedAFileOrRefusesTo) {
  const std::string clip = write("walk.bvh", test_bvh());
  ASSERT_EQ(mocapress({"compress", clip, "-o", file("walk.mcpr")}).exit_code, 0);
  const std::vector<std::string> anew = {"decompress", file("walk.mcpr"), "-o", file("new.amc")};
  EXPECT_THAT(mocapress(anew).err, testing::Not(HasSubstr("replaced")));
  const Outcome again = mocapress(anew);
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_THAT(again.err, HasSubstr("new.amc: replaced the file that was there"));
  EXPECT_THAT(again.err, HasSubstr("new.asf: replaced the file that was there"));
  fs::remove(file("new.amc"));
  write("new.asf", "mine");
  std::vector<std::string> careful = anew;
  careful.emplace_back("--no-clobber");
  EXPECT_EQ(mocapress(careful).exit_code, 5);
  EXPECT_EQ(read_text(file("new.asf")), "mine");
  EXPECT_FALSE(fs::exists(file("new.amc")));
}

TEST_F(CliWriting, ADashIsAStreamOrRefusedAndNeverAFile) {
  const std::string clip = write("walk.bvh", test_bvh());
  const auto piped = [&](const std::string& words) {
    return run_program(
        {"sh", "-c", "cd '" + file("").string() + "' && " + words, "sh", MOCAPRESS_EXECUTABLE});
  };
  const Outcome made = piped("\"$1\" compress - --format bvh -o - < walk.bvh > piped.mcpr");
  EXPECT_EQ(made.exit_code, 0) << made.err;
  ASSERT_EQ(mocapress({"compress", clip, "-o", file("walk.mcpr")}).exit_code, 0);
  EXPECT_EQ(read_bytes(file("piped.mcpr")), read_bytes(file("walk.mcpr")));
  ASSERT_EQ(mocapress({"decompress", file("walk.mcpr"), "-o", file("back.bvh")}).exit_code, 0);
  const Outcome back = mocapress({"decompress", file("walk.mcpr"), "-o", "-", "--format", "bvh"});
  EXPECT_EQ(back.out, read_text(file("back.bvh")));
  const Outcome damaged = piped("echo MOTION | \"$1\" compress - --format bvh -o -");
  EXPECT_EQ(damaged.exit_code, 3);
  EXPECT_THAT(damaged.err, testing::StartsWith("mocapress: standard input:1:")) << "no .bvh";
  for (const char* words :
       {"compress - < walk.bvh", "compress walk.bvh -o - --json", "compress walk.bvh --format bvh",
        "decompress walk.mcpr -o -", "decompress - -o a.bvh", "info -", "measure walk.bvh -",
        "contacts walk.bvh -o -", "batch walk.bvh -o -", "batch - -o out", "study walk.bvh -o -",
        "bank make - walk.mcpr", "bank extract - -o out"}) {
    const Outcome refused = piped("\"$1\" " + std::string(words));
    EXPECT_EQ(refused.exit_code, 2) << words << ": " << refused.err;
    EXPECT_NE(refused.err, "") << words;
  }
  EXPECT_FALSE(fs::exists(file("-")));
}

TEST_F(CliWriting, AFullStandardOutputIsFive) {
  const std::string clip = write("walk.bvh", test_bvh());
  EXPECT_EQ(run_program({"sh", "-c", "\"$@\" > /dev/full", "sh", MOCAPRESS_EXECUTABLE, "compress",
                         clip, "-o", "-"})
                .exit_code,
            5);
}

TEST_F(CliWriting, ASlurmScriptThatCannotNameItsFolderIsRefusedBeforeAnythingIsWritten) {
  write_sample_clips(file("in"), 1);
  const Outcome outcome =
      mocapress({"batch", file("in"), "-o", file("two\nlines"), "--write-slurm", file("job.sh")});
  EXPECT_EQ(outcome.exit_code, 5);
  EXPECT_THAT(outcome.err, testing::ContainsRegex("two.lines.*: it has a line break"));
  EXPECT_FALSE(fs::exists(file("job.sh")));
  EXPECT_FALSE(fs::exists(file("two\nlines")));
}

TEST_F(CliWriting, ASlurmScriptPassesTheLimitsOnToItsTasks) {
  write_sample_clips(file("in"), 1);
  ASSERT_EQ(mocapress({"batch", file("in"), "-o", file("out"), "--memory", "512MiB",
                       "--clip-timeout", "90.5", "--write-slurm", file("job.sh")})
                .exit_code,
            0);
  const std::string script = read_text(file("job.sh"));
  EXPECT_THAT(script, testing::HasSubstr("--memory \\\n    536870912"));
  EXPECT_THAT(script, testing::HasSubstr("--clip-timeout \\\n    90.5"));
}

}  // namespace
}  // namespace mocapress::test
