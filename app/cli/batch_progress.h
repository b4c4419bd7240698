// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/terminal.h"
#include "core/batch/run.h"

namespace mocapress::cli {

/// Reports a running batch: a line on standard error, or lines of JSON on standard output.
class BatchReporter {
 public:
  BatchReporter(const Batch& batch, bool json);

  void begin(const std::filesystem::path& folder, const Shard& shard) const;
  void tell(const BatchProgress& progress);
  void end(const BatchOutcome& outcome, const std::filesystem::path& report) const;

 private:
  void tell(const BankProgress& bank);
  void print_step(const BatchProgress& progress);
  void print_row(const BatchProgress& progress);

  const Batch& batch_;
  bool json_;
  ProgressLine line_;
  TimeLeft time_left_;
  std::string last_;                // the clip that ended last
  std::size_t warned_ = 0;          // clips with a warning from their reader
  double next_step_ = 0;            // s, time of the next report within clips
  std::vector<std::size_t> begun_;  // clips in progress
};

}  // namespace mocapress::cli
