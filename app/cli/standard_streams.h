// SPDX-License-Identifier: GPL-3.0-or-later
// Standard input and standard output, named "-" on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace mocapress::cli {

inline constexpr std::string_view kStandardStream = "-";

/// Reads all of standard input. Throws InputError.
std::string read_standard_input();

/// Throws WriteError.
void write_standard_output(std::string_view bytes);

/// Refuses "-" for every option of `app`'s commands that cannot use standard input or output. "-"
/// never means a file of that name.
void refuse_streams(CLI::App& app);

}  // namespace mocapress::cli
