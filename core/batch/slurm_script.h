// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace mocapress {

/// A batch for the machines of a Slurm cluster, which share a file system.
struct SlurmJob {
  std::string program;                 // mocapress, as the machines find it
  std::vector<std::string> arguments;  // of `mocapress batch`: inputs and settings, not -o
  std::string folder;                  // of the batch, as the machines find it
  int shards = 8;                      // tasks of the array
  int processors = 4;                  // of each
};

/// A script for sbatch: an array of one task a shard, each of which may be requeued and then goes
/// on where it was, and a job that merges their reports when all have ended. Throws WriteError
/// where a name cannot be quoted: one with control characters, or a folder with a backslash.
std::string slurm_script(const SlurmJob& job);

}  // namespace mocapress
