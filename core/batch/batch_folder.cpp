// SPDX-License-Identifier: MIT
#include "core/batch/batch_folder.h"

#include "core/base/error.h"
#include "core/batch/report.h"

namespace mocapress {
namespace {

namespace fs = std::filesystem;

std::string suffix_of(const Shard& shard) {
  if (shard.count == 1) return "";
  return "-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
}

Journal::Start start_of(const BatchRunOptions& options) {
  if (options.resumed) return Journal::Start::Resume;
  return options.overwrite ? Journal::Start::Anew : Journal::Start::New;
}

}  // namespace

std::string journal_name(const Shard& shard) {
  return "batch" + suffix_of(shard) + ".jsonl";
}

std::string report_name(const Shard& shard) {
  return "report" + suffix_of(shard) + ".html";
}

BatchOutcome run_batch_in(const fs::path& folder, const Batch& batch,
                          const BatchRunOptions& options, BatchControl& control,
                          const Observer<BatchProgress>& observer) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WriteError(folder.string() + ": cannot be made: " + error.message());
  const fs::path journal_path = folder / journal_name(options.shard);
  BatchOutcome outcome;
  {
    Journal journal(journal_path, batch, options.shard, start_of(options));
    outcome = run_batch(batch, folder, journal, options, control, observer);
    if (journal.warning()) outcome.warnings.push_back(*journal.warning());
  }
  if (!outcome.complete) return outcome;
  JournalReader reader(journal_path);
  write_batch_report(
      folder, suffix_of(options.shard), [&](const auto& visit) { reader.for_each(visit); }, 0);
  return outcome;
}

}  // namespace mocapress
