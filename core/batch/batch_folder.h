// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/batch/run.h"

namespace mocapress {

/// The names of a shard's files in the folder of a batch: "batch.jsonl", "report.html" of a whole
/// batch, "batch-2-of-8.jsonl" of a part.
std::string journal_name(const Shard& shard);
std::string report_name(const Shard& shard);

/// run_batch() with the journal in `folder`, which is made, and the reports when nothing is waiting
/// any more. Throws WriteError, also where the folder holds a journal and options neither resume
/// nor overwrite.
BatchOutcome run_batch_in(const std::filesystem::path& folder, const Batch& batch,
                          const BatchRunOptions& options, BatchControl& control,
                          const Observer<BatchProgress>& observer = {});

}  // namespace mocapress
