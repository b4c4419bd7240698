// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/batch/run.h"

namespace mocapress {

/// The names of a shard's files in the folder of a batch: "batch.jsonl", "report.html" of a whole
/// batch, "batch-2-of-8.jsonl" of a part.
std::string journal_name(const Shard& shard);
std::string report_name(const Shard& shard);

/// Of all clips, by the names of their outputs.
inline constexpr const char* kBankOfBatch = "bank.mcpk";

/// run_batch() with the journal in `folder`, which is made, and the reports and the bank when
/// nothing is waiting any more. Throws WriteError, also where the folder holds a journal or a bank
/// and options neither resume nor overwrite; and Error for what check() refuses, and for the bank
/// of a shard, which has not all clips.
BatchOutcome run_batch_in(const std::filesystem::path& folder, const Batch& batch,
                          const BatchRunOptions& options, BatchControl& control,
                          const Observer<BatchProgress>& observer = {});

/// What the shards of a batch came to together.
struct MergedBatch {
  std::size_t clips = 0;
  std::size_t failed = 0;
  std::size_t waiting = 0;  // no shard has a row of them
};

/// Writes into `folder` the reports of all journals in `folders` as if one run had made them, and
/// shows every row to `visit`.
/// Throws InputError when there is none or they are not of one batch, WriteError.
MergedBatch merge_batch(const std::vector<std::filesystem::path>& folders,
                        const std::filesystem::path& folder,
                        const std::function<void(const BatchRow&)>& visit = {});

}  // namespace mocapress
