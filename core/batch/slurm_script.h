// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace mocapress {

/// A batch to run on machines of a Slurm cluster that share a file system.
struct SlurmJob {
  std::string program;  // path of mocapress on the machines
  // Arguments of `mocapress batch`: inputs and settings, without -o.
  std::vector<std::string> arguments;
  std::string folder;  // path of the batch's folder on the machines
  int shards = 8;      // number of array tasks
  int processors = 4;  // for each task
};

/// A script for sbatch: an array with one task for each shard, which resumes if it is requeued, and
/// a job that merges their reports at the end. Throws WriteError for a name that cannot be quoted:
/// one with control characters, or a folder with a backslash.
std::string slurm_script(const SlurmJob& job);

}  // namespace mocapress
