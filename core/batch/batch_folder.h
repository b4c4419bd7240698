// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/batch/run.h"

namespace mocapress {

/// The names of a shard's files in the folder of a batch: "batch.jsonl" and "report.html" for a
/// whole batch, "batch-2-of-8.jsonl" for a part.
std::string journal_name(const Shard& shard);
std::string report_name(const Shard& shard);

/// The bank of all clips; each clip has its output's name.
inline constexpr const char* kBankOfBatch = "bank.mcpk";

/// Runs a batch with its journal in `folder`, which is created. Once no clip is waiting, writes the
/// reports and the bank. Throws WriteError, also if the folder holds a journal or a bank and
/// options neither resume nor overwrite. Throws Error for what check() refuses, and for a bank of a
/// shard, which would lack clips.
BatchOutcome run_batch_in(const std::filesystem::path& folder, const Batch& batch,
                          const BatchRunOptions& options, BatchControl& control,
                          const Observer<BatchProgress>& observer = {});

/// Passes the rows of all journals in a folder to `visit`, in the order of the batch. Returns how
/// many of its clips are still waiting: the batch was interrupted, or rows are damaged. Throws
/// InputError if there is no journal.
std::size_t visit_rows(const std::filesystem::path& folder,
                       const std::function<void(const BatchRow&)>& visit);

/// The joint result of the shards of a batch.
struct MergedBatch {
  std::size_t clips = 0;
  std::size_t failed = 0;
  std::size_t waiting = 0;  // clips without a row in any shard
};

/// Writes the reports of all journals in `folders` into `folder`, as if one run had made them, and
/// passes every row to `visit`. Throws InputError if there is no journal or they belong to
/// different batches; throws WriteError.
MergedBatch merge_batch(const std::vector<std::filesystem::path>& folders,
                        const std::filesystem::path& folder,
                        const std::function<void(const BatchRow&)>& visit = {});

}  // namespace mocapress
