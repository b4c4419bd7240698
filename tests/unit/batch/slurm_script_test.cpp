// SPDX-License-Identifier: MIT
#include "core/batch/slurm_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "core/base/error.h"
#include "core/base/file.h"

namespace mocapress {
namespace {

using testing::HasSubstr;

TEST(SlurmScript, AsksForWhatAnArrayThatMayBeRequeuedNeeds) {
  const std::string script = slurm_script({.program = "mocapress",
                                           .arguments = {"a b.json"},
                                           .folder = "/out put/100%",
                                           .shards = 12,
                                           .processors = 3});
  EXPECT_TRUE(script.starts_with("#!/bin/bash\n"));
  for (const char* line :
       {"#SBATCH --array=1-12\n", "#SBATCH --cpus-per-task=3\n", "#SBATCH --open-mode=append\n",
        "#SBATCH --requeue\n", "#SBATCH --output=\"/out put/100%%/slurm-%A_%a.log\"\n",
        "folder='/out put/100%'\n", "'a b.json'", "--resume", "afterany:$SLURM_ARRAY_JOB_ID"})
    EXPECT_THAT(script, HasSubstr(line));
}

TEST(SlurmScript, IsAScriptThatTheShellCanReadWhateverTheNames) {
  const std::string script = slurm_script({.program = "/opt/it's $HOME/mocapress",
                                           .arguments = {"`x`.json", "--name", "{stem}; rm"},
                                           .folder = "/a'b\"c$(d)"});
  const std::string file = testing::TempDir() + "/batch-script-" + std::to_string(getpid()) + ".sh";
  write_text(file, script);
  EXPECT_EQ(std::system(("bash -n '" + file + "'").c_str()), 0);
}

TEST(SlurmScript, QuotesTheLogsAsSbatchReadsThem) {
  EXPECT_THAT(slurm_script({.program = "mocapress", .folder = "/a \"b\"/50%"}),
              HasSubstr("#SBATCH --output=\"/a \\\"b\\\"/50%%/slurm-%A_%a.log\"\n"));
}

TEST(SlurmScript, RefusesWhatCannotBeQuoted) {
  const auto refusal = [](const SlurmJob& job) -> std::string {
    try {
      slurm_script(job);
      return "";
    } catch (const WriteError& error) {
      return error.what();
    }
  };
  const auto of_folder = [&](const std::string& folder) {
    return refusal({.program = "mocapress", .folder = folder});
  };
  EXPECT_EQ(of_folder("/out/run\nexec evil"),
            "a script for sbatch cannot name /out/run?exec evil: it has a line break or another "
            "control character in it");
  for (const char* control : {"\r", "\t", "\x1b", "\x7f"})
    EXPECT_THAT(of_folder(std::string("/out/") + control), HasSubstr("control character"));
  EXPECT_THAT(of_folder(std::string("/out/\0/x", 8)), HasSubstr("control character"));
  EXPECT_THAT(of_folder("/out\\put"), HasSubstr("a backslash"));
  EXPECT_THAT(refusal({.program = "/opt/a\nb", .folder = "/out"}), HasSubstr("/opt/a?b"));
  EXPECT_THAT(refusal({.program = "mocapress", .arguments = {"a\nb.json"}, .folder = "/out"}),
              HasSubstr("a?b.json"));
  EXPECT_EQ(of_folder("/out/Läufe und Sprünge, 'alle'"), "");
}

}  // namespace
}  // namespace mocapress
