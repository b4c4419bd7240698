// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace mocapress::cli {

// Scripts depend on these.
enum ExitCode : int {
  kDone = 0,
  kInternal = 1,
  kUsage = 2,
  kBadInput = 3,
  kTargetMissed = 4,
  kCannotWrite = 5,
  kSomeFailed = 7
};

/// Thrown by a command that did not do all it was asked to and has said why.
struct EndedWith {
  int exit_code;
};

// Each adds its subcommand, whose callback does the work and throws what goes wrong.
void add_info(CLI::App& app);
void add_compress(CLI::App& app);
void add_decompress(CLI::App& app);
void add_measure(CLI::App& app);
void add_contacts(CLI::App& app);
void add_bench(CLI::App& app);
void add_study(CLI::App& app);
void add_batch(CLI::App& app);
void add_bank(CLI::App& app);

}  // namespace mocapress::cli
