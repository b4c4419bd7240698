// SPDX-License-Identifier: MIT
// Runs a batch on a real Slurm with one node, which the test starts. Skipped if Slurm is not
// installed (Debian: slurmctld slurmd slurm-client munge) or does not start.
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/file.h"
#include "tests/system/command.h"
#include "tests/system/sample_clips.h"

namespace mocapress::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Slurm : public CommandLine {
 protected:
  void SetUp() override {
    const Outcome started = run_program({kScript, "start", node(), std::to_string(getpid())});
    if (started.exit_code == 9) GTEST_SKIP() << started.err;
    ASSERT_EQ(started.exit_code, 0) << started.err;
    setenv("SLURM_CONF", (node() / "slurm.conf").c_str(), 1);
  }
  ~Slurm() override {
    unsetenv("SLURM_CONF");
    run_program({kScript, "stop", node()});
  }

  fs::path node() const { return file("node"); }
  fs::path out() const { return file("out"); }

  /// Slurm's programs wait for daemons, so their time is limited.
  static Outcome slurm(std::vector<std::string> words) {
    words.insert(words.begin(), {"timeout", "120"});
    return run_program(words);
  }

  static bool queue_is_empty() {
    const Outcome queue = slurm({"squeue", "--noheader"});
    return queue.exit_code == 0 && queue.out.empty();
  }

  std::string log_of(int task) const {
    for (const auto& entry : fs::directory_iterator(out()))
      if (entry.path().filename().string().ends_with("_" + std::to_string(task) + ".log"))
        return read_text(entry.path());
    return "";
  }

  /// All logs of Slurm and of the tasks, for finding errors.
  std::string logs() const {
    std::string all = slurm({"squeue", "--long"}).out;
    for (const fs::path& folder : {out(), node()})
      for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".log")
          all += "== " + entry.path().filename().string() + '\n' + read_text(entry.path());
    return all;
  }

  const std::string kScript = MOCAPRESS_SOURCE_DIR "/tests/system/single_node_slurm";
};

TEST_F(Slurm, AnArrayOfShardsOneOfThemRequeuedAndItsMergeAreAsOneRun) {
  write_sample_clips(file("in"), 16);  // enough that work is left when the task is requeued
  const std::vector<std::string> settings = {"--max-error", "0.1", "--jobs", "1"};
  std::vector<std::string> whole = {"batch", file("in"), "-o", file("whole")};
  whole.insert(whole.end(), settings.begin(), settings.end());
  ASSERT_EQ(mocapress(whole).exit_code, 0);

  std::vector<std::string> asked = {"batch",        file("in"),      "-o", out(), "--write-slurm",
                                    file("job.sh"), "--slurm-tasks", "2"};
  asked.insert(asked.end(), settings.begin(), settings.end());
  const Outcome written = mocapress(asked);
  ASSERT_EQ(written.exit_code, 0) << written.err;
  const Outcome submitted = slurm({"sbatch", "--parsable", file("job.sh")});
  ASSERT_EQ(submitted.exit_code, 0) << submitted.err;
  const std::string job = submitted.out.substr(0, submitted.out.find('\n'));

  ASSERT_TRUE(comes_true([&] { return log_of(1).find("clip-done") != std::string::npos; }))
      << logs();
  const Outcome requeued = slurm({"scontrol", "requeue", job + "_1"});
  EXPECT_EQ(requeued.exit_code, 0) << requeued.err;

  ASSERT_TRUE(comes_true([&] { return fs::exists(out() / "report.html") && queue_is_empty(); }))
      << logs();
  EXPECT_THAT(log_of(1), HasSubstr("\"stopped\"")) << "it was asked to end";
  EXPECT_THAT(log_of(1), HasSubstr("clip-kept")) << "and went on, its log appended to";
  EXPECT_THAT(read_text(out() / "slurm-merge.log"), HasSubstr("16 clips, 0 failed, 0 still"));
  const auto together = batch_contents(out());
  for (const auto& [name, text] : batch_contents(file("whole")))
    EXPECT_EQ(together.at(name), text) << name;
}

}  // namespace
}  // namespace mocapress::test
