// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/batch/run.h"

namespace mocapress {

/// The names of a shard's files in the batch's folder: "batch.jsonl" and "report.html" for the
/// whole batch, "batch-2-of-8.jsonl" for a part.
std::string journal_name(const Shard& shard);
std::string report_name(const Shard& shard);

/// The bank of all clips. A clip's name in the bank is its output.
inline constexpr const char* kBankOfBatch = "bank.mcpk";

/// Runs a batch with its journal in `folder`, which is created if needed. Once no clip is waiting,
/// writes the reports and the bank. Throws WriteError, also if the folder already holds a journal
/// or a bank and the options neither resume nor overwrite. Throws Error for a batch that check()
/// refuses, and for a bank of a single shard, which would lack clips.
BatchOutcome run_batch_in(const std::filesystem::path& folder, const Batch& batch,
                          const BatchRunOptions& options, BatchControl& control,
                          const Observer<BatchProgress>& observer = {});

/// Passes the rows of all journals in a folder to `visit`, in the order of the batch. Returns the
/// number of clips without a row: the batch was interrupted, or rows are damaged. Throws InputError
/// if there is no journal.
std::size_t visit_rows(const std::filesystem::path& folder,
                       const std::function<void(const BatchRow&)>& visit);

/// The combined result of a batch's shards.
struct MergedBatch {
  std::size_t clips = 0;
  std::size_t failed = 0;
  std::size_t waiting = 0;  // clips without a row in any shard
};

/// Writes reports into `folder` from all journals in `folders`, as if one run had done all clips,
/// and passes every row to `visit`. Throws InputError if there is no journal or if they belong to
/// different batches; throws WriteError.
MergedBatch merge_batch(const std::vector<std::filesystem::path>& folders,
                        const std::filesystem::path& folder,
                        const std::function<void(const BatchRow&)>& visit = {});

}  // namespace mocapress
