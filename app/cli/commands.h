// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace mocapress::cli {

// Each adds its subcommand, whose callback does the work and throws what goes wrong.
void add_info(CLI::App& app);
void add_compress(CLI::App& app);
void add_decompress(CLI::App& app);
void add_measure(CLI::App& app);
void add_bench(CLI::App& app);

}  // namespace mocapress::cli
