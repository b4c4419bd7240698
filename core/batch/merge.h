// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

namespace mocapress {

/// What the shards of a batch came to together.
struct MergedBatch {
  std::size_t clips = 0;
  std::size_t failed = 0;
  std::size_t waiting = 0;  // no shard has a row of them
};

/// Writes into `folder` the reports of all journals in `folders` as if one run had made them.
/// Throws InputError when there is none or they are not of one batch, WriteError.
MergedBatch merge_batch(const std::vector<std::filesystem::path>& folders,
                        const std::filesystem::path& folder);

}  // namespace mocapress
