// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/batch_progress.h"

#include <algorithm>
#include <cstdio>

#include "app/cli/motion_input.h"
#include "core/base/number_text.h"
#include "core/base/utf8_path.h"
#include "core/batch/batch_folder.h"
#include "core/formats/text_writer.h"
#include "core/mocapress/settings_json.h"

#include <nlohmann/json.hpp>

namespace mocapress::cli {
namespace {

constexpr double kStepInterval = 0.25;  // seconds

void print_line(const Json& json) {
  std::printf("%s\n", dumped(json).c_str());
  std::fflush(stdout);  // shows lines at once, and keeps them if a signal ends the program
}

std::string described(const BatchRow& row) {
  std::string text = utf8(utf8_path(row.input).filename());
  if (!row.done()) return text + ": " + row.error;
  return text + " " + fixed_text(row.measured->ratio, 1) + ":1 " +
         fixed_text(row.measured->eps_cm(row.preset.weighting), 3) + " cm";
}

Json counts_json(const BatchCounts& counts, const std::optional<double>& seconds_left) {
  return {{"done", counts.done},
          {"kept", counts.kept},
          {"failed", counts.failed},
          {"clips", counts.clips},
          {"seconds_left", seconds_left ? Json(*seconds_left) : Json()}};
}

std::string bank_beside(const std::filesystem::path& report) {
  return utf8(report.parent_path() / kBankOfBatch);
}

}  // namespace

BatchReporter::BatchReporter(const Batch& batch, bool json)
    : batch_(batch), json_(json), line_(json) {}

void BatchReporter::begin(const std::filesystem::path& folder, const Shard& shard) const {
  if (!json_) return;
  print_line({{"event", "begin"},
              {"folder", utf8(folder)},
              {"clips_in_all", batch_.items.size()},
              {"shard", shard.index},
              {"shards", shard.count}});
}

void BatchReporter::tell(const BatchProgress& progress) {
  if (progress.bank) return tell(*progress.bank);
  const bool ended = progress.row != nullptr;
  time_left_.update(progress.counts, line_.elapsed_seconds());
  if (json_) {
    ended ? print_row(progress) : print_step(progress);
    return;
  }
  if (ended) last_ = described(*progress.row);
  if (ended && !progress.row->done()) {
    line_.clear();
    std::fprintf(stderr, "failed: %s: %s\n", printable(progress.row->input).c_str(),
                 printable(progress.row->error).c_str());
  }
  if (ended) {
    for (const std::string& warning : progress.row->warnings) {
      line_.clear();
      std::fprintf(stderr, "warning: %s\n", printable(warning).c_str());
    }
    warned_ += !progress.row->warnings.empty();
  }
  if (!line_.due()) return;
  const double now = line_.elapsed_seconds();
  const auto& left = time_left_.seconds();
  line_.show(std::to_string(progress.counts.done) + " of " + std::to_string(progress.counts.clips) +
             ", " + clock_text(now) + (left ? ", about " + clock_text(*left) + " left" : "") +
             "   " + last_);
}

void BatchReporter::tell(const BankProgress& bank) {
  if (json_) {
    const double now = line_.elapsed_seconds();
    const bool is_last = bank.clips > 0 && bank.done == bank.clips;
    if (!is_last && now < next_step_) return;
    next_step_ = now + kStepInterval;
    print_line({{"event", "bank-step"}, {"done", bank.done}, {"clips", bank.clips}});
  } else if (line_.due()) {
    line_.show("bank: " + (bank.clips > 0
                               ? std::to_string(bank.done) + " of " + std::to_string(bank.clips)
                               : "waiting, another program is changing it"));
  }
}

void BatchReporter::print_step(const BatchProgress& progress) {
  const bool is_new = std::find(begun_.begin(), begun_.end(), progress.index) == begun_.end();
  if (is_new) begun_.push_back(progress.index);
  const double now = line_.elapsed_seconds();
  if (!is_new && now < next_step_) return;
  next_step_ = now + kStepInterval;
  print_line({{"event", is_new ? "clip-begun" : "clip-step"},
              {"index", progress.index},
              {"input", batch_.items[progress.index].input},
              {"stage", name(progress.clip.stage)},
              {"fraction", progress.clip.fraction}});
}

void BatchReporter::print_row(const BatchProgress& progress) {
  std::erase(begun_, progress.index);
  const BatchRow& row = *progress.row;
  Json json = {{"event", !row.done()     ? "clip-failed"
                         : progress.kept ? "clip-kept"
                                         : "clip-done"},
               {"index", row.index},
               {"batch", counts_json(progress.counts, time_left_.seconds())}};
  json.update(parse_json("", to_report_line(row)));
  json["encode_seconds"] = row.measured ? Json(row.measured->encode_seconds) : Json();
  print_line(json);
}

void BatchReporter::end(const BatchOutcome& outcome, const std::filesystem::path& report) const {
  const BatchCounts& counts = outcome.counts;
  line_.clear();
  print_warnings(outcome.warnings);
  if (json_) {
    print_line({{"event", outcome.complete ? "end" : "stopped"},
                {"batch", counts_json(counts, time_left_.seconds())},
                {"report", outcome.complete ? Json(utf8(report)) : Json()},
                {"bank", outcome.has_bank ? Json(bank_beside(report)) : Json()}});
    return;
  }
  std::fprintf(stderr, "%zu of %s done", counts.done - counts.failed,
               counted(counts.clips, "clip").c_str());
  if (counts.kept > 0) std::fprintf(stderr, ", %zu of them by an earlier run", counts.kept);
  if (warned_ > 0) std::fprintf(stderr, ", %zu of them with warnings", warned_);
  if (counts.failed > 0) std::fprintf(stderr, "; %zu failed", counts.failed);
  std::fprintf(stderr, "\n");
  if (outcome.complete) std::fprintf(stderr, "%s\n", printable(utf8(report)).c_str());
  if (outcome.has_bank) std::fprintf(stderr, "%s\n", printable(bank_beside(report)).c_str());
}

}  // namespace mocapress::cli
