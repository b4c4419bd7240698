// SPDX-License-Identifier: MIT
#include "core/batch/slurm_script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

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
  const std::string file = testing::TempDir() + "/batch-script.sh";
  write_text(file, script);
  EXPECT_EQ(std::system(("bash -n '" + file + "'").c_str()), 0);
}

}  // namespace
}  // namespace mocapress
