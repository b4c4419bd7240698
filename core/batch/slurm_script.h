// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace mocapress {

/// A batch to run on a Slurm cluster whose machines share a file system.
struct SlurmJob {
  std::string program;  // path of mocapress on those machines
  // Arguments of `mocapress batch`: inputs and settings, without -o.
  std::vector<std::string> arguments;
  std::string folder;  // path of the batch's folder on those machines
  int shards = 8;      // number of array tasks
  int processors = 4;  // for each task
};

/// Returns a script for sbatch: an array with one task for each shard, which resumes when it is
/// requeued, and a last job that merges the shards' reports. Throws WriteError for text that cannot
/// be quoted: a name with control characters, or a folder with a backslash.
std::string slurm_script(const SlurmJob& job);

}  // namespace mocapress
