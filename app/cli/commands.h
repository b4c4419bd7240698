// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace mocapress::cli {

// Exit codes, which scripts depend on.
enum ExitCode : int {
  kDone = 0,
  kInternal = 1,
  kUsage = 2,
  kBadInput = 3,
  kTargetMissed = 4,
  kCannotWrite = 5,
  kSomeFailed = 7
};

/// Thrown by a command that failed in part and has reported it already.
struct EndedWith {
  int exit_code;
};

// Each function adds a subcommand. Its callback does the work and throws on errors.
void add_info(CLI::App& app);
void add_compress(CLI::App& app);
void add_decompress(CLI::App& app);
void add_measure(CLI::App& app);
void add_contacts(CLI::App& app);
void add_bench(CLI::App& app);
void add_study(CLI::App& app);
void add_batch(CLI::App& app);
void add_diff(CLI::App& app);
void add_signoff(CLI::App& app);
void add_bank(CLI::App& app);

}  // namespace mocapress::cli
