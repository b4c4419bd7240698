// SPDX-License-Identifier: MIT
#include "core/batch/batch_folder.h"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "core/base/error.h"
#include "core/batch/journal.h"
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

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("batch") && name.ends_with(".jsonl")) found.push_back(entry.path());
  }
  if (error) throw InputError(folder.string(), 0, 0, error.message());
  std::sort(found.begin(), found.end());
  return found;
}

/// Gives the rows of several journals in the order of the batch. Every journal has its rows in that
/// order, and no two have the same ones.
void visit_in_order(std::vector<std::unique_ptr<JournalReader>>& journals,
                    const std::function<void(const BatchRow&)>& visit) {
  std::map<std::size_t, std::pair<JournalReader*, std::size_t>> places;  // by index of the clip
  for (const auto& journal : journals)
    for (std::size_t place = 0; place < journal->rows(); ++place)
      places[journal->index_at(place)] = {journal.get(), place};
  for (const auto& [index, place] : places)
    if (const auto row = place.first->row_at(place.second)) visit(*row);
}

}  // namespace

MergedBatch merge_batch(const std::vector<fs::path>& folders, const fs::path& folder) {
  std::vector<std::unique_ptr<JournalReader>> journals;
  for (const fs::path& one : folders)
    for (const fs::path& path : journals_in(one)) {
      journals.push_back(std::make_unique<JournalReader>(path));
      const JournalHeader& first = journals.front()->header();
      const JournalHeader& header = journals.back()->header();
      if (header.list != first.list || header.clips != first.clips)
        throw InputError(path.string(), 0, 0, "is not of the same batch as the others");
    }
  if (journals.empty())
    throw InputError(folders.empty() ? "" : folders.front().string(), 0, 0,
                     "holds no journal of a batch");
  MergedBatch merged{.clips = journals.front()->header().clips};
  std::size_t rows = 0;
  const BatchRows in_order = [&](const auto& visit) { visit_in_order(journals, visit); };
  in_order([&](const BatchRow& row) {
    ++rows;
    merged.failed += !row.done();
  });
  merged.waiting = merged.clips - std::min(rows, merged.clips);
  std::error_code error;
  fs::create_directories(folder, error);
  write_batch_report(folder, "", in_order, merged.waiting);
  return merged;
}

}  // namespace mocapress
