// SPDX-License-Identifier: MIT
#include "core/batch/batch_folder.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "core/bank/bank.h"
#include "core/base/error.h"
#include "core/base/folder_listing.h"
#include "core/base/make_folders.h"
#include "core/base/path_kind.h"
#include "core/base/utf8_path.h"
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

/// Throws, before any work, if the bank cannot be made.
void check_bank(const fs::path& folder, const Batch& batch, const BatchRunOptions& options) {
  if (!batch.bank) return;
  if (options.shard.count > 1)
    throw Error(
        "a shard has not all clips of a bank: make it of the .mcpr files when all are done");
  const fs::path bank = folder / kBankOfBatch;
  const bool own = options.resumed && is_there(folder / journal_name(options.shard));
  if (is_there(bank) && !own && !options.overwrite)
    throw WriteError(utf8(bank) + " exists: not overwritten");
}

/// Makes the bank. Returns false if it would have no clip, or if the observer stopped it.
bool make_bank_of(const fs::path& folder, const BankOptions& options, const JournalReader& reader,
                  BatchControl& control, BatchProgress progress, Warnings& warnings,
                  const Observer<BatchProgress>& observer) {
  std::vector<BankSource> sources;
  reader.for_each([&](const BatchRow& row) {
    if (row.done()) sources.push_back({row.output, folder / utf8_path(row.output + ".mcpr"), {}});
  });
  if (sources.empty()) return false;
  return make_bank(folder / kBankOfBatch, std::move(sources), options,
                   [&](const BankProgress& bank) {
                     if (bank.warning) warnings.push_back(*bank.warning);
                     progress.bank = bank;
                     if (!should_continue(observer, progress)) control.cancel();
                     return control.may_continue();
                   });
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
  check(batch);
  check_bank(folder, batch, options);
  make_folders(folder);
  const fs::path journal_path = folder / journal_name(options.shard);
  BatchOutcome outcome;
  {
    Journal journal(journal_path, batch, options.shard, start_of(options), options.take_over);
    outcome = run_batch(batch, folder, journal, options, control, observer);
    if (journal.warning()) outcome.warnings.push_back(*journal.warning());
  }
  if (!outcome.complete) return outcome;
  const JournalReader reader(journal_path);
  write_batch_report(
      folder, suffix_of(options.shard), [&](const auto& visit) { reader.for_each(visit); }, 0,
      options.language);
  if (batch.bank) {
    tbb::task_arena arena(options.jobs > 0 ? options.jobs : tbb::task_arena::automatic);
    arena.execute([&] {
      outcome.has_bank =
          make_bank_of(folder, {.form = *batch.bank, .learn = batch.learn}, reader, control,
                       {.counts = outcome.counts}, outcome.warnings, observer);
    });
    outcome.complete = !control.cancelled();
  }
  return outcome;
}

namespace {

namespace fs = std::filesystem;

using Journals = std::vector<std::unique_ptr<JournalReader>>;

std::vector<fs::path> journals_in(const fs::path& folder) {
  std::vector<fs::path> found;
  const FolderListing listing = list_folder(folder);
  for (const FolderEntry& entry : listing.entries) {
    const std::string name = utf8(entry.path.filename());
    if (name.starts_with("batch") && name.ends_with(".jsonl")) found.push_back(entry.path);
  }
  if (!listing.problem.empty()) throw InputError(utf8(folder), 0, 0, listing.problem);
  std::ranges::sort(found);
  return found;
}

/// Visits the rows of several journals in the order of the batch. Each journal has its rows in that
/// order, and no two journals share a row.
void visit_in_order(const Journals& journals, const std::function<void(const BatchRow&)>& visit) {
  std::map<std::size_t, std::pair<JournalReader*, std::size_t>> places;  // by index of the clip
  for (const auto& journal : journals)
    for (std::size_t place = 0; place < journal->rows(); ++place)
      places[journal->index_at(place)] = {journal.get(), place};
  for (const auto& [index, place] : places) visit(place.first->row_at(place.second));
}

/// Opens the journals in some folders. Throws InputError if there is none, or if they belong to
/// different batches.
Journals open_journals(const std::vector<fs::path>& folders) {
  Journals journals;
  for (const fs::path& one : folders)
    for (const fs::path& path : journals_in(one)) {
      journals.push_back(std::make_unique<JournalReader>(path));
      const JournalHeader& first = journals.front()->header();
      const JournalHeader& header = journals.back()->header();
      if (header.list != first.list || header.clips != first.clips)
        throw InputError(utf8(path), 0, 0, "is not of the same batch as the others");
    }
  if (journals.empty())
    throw InputError(folders.empty() ? "" : utf8(folders.front()), 0, 0,
                     "holds no journal of a batch");
  return journals;
}

}  // namespace

std::size_t visit_rows(const fs::path& folder, const std::function<void(const BatchRow&)>& visit) {
  const Journals journals = open_journals({folder});
  std::size_t waiting = journals.front()->header().clips;
  visit_in_order(journals, [&](const BatchRow& row) {
    if (waiting > 0) --waiting;
    visit(row);
  });
  return waiting;
}

MergedBatch merge_batch(const std::vector<fs::path>& folders, const fs::path& folder,
                        const std::function<void(const BatchRow&)>& visit) {
  const Journals journals = open_journals(folders);
  MergedBatch merged{.clips = journals.front()->header().clips};
  std::size_t rows = 0;
  const BatchRows in_order = [&](const auto& each) { visit_in_order(journals, each); };
  in_order([&](const BatchRow& row) {
    ++rows;
    merged.failed += !row.done();
    if (visit) visit(row);
  });
  merged.waiting = merged.clips - std::min(rows, merged.clips);
  make_folders(folder);
  write_batch_report(folder, "", in_order, merged.waiting);
  return merged;
}

}  // namespace mocapress
