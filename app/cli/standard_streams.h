// SPDX-License-Identifier: GPL-3.0-or-later
// "-" on the command line: standard input and standard output.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace mocapress::cli {

inline constexpr std::string_view kStandardStream = "-";

/// All of standard input. Throws InputError.
std::string read_standard_input();

/// Throws WriteError.
void write_standard_output(std::string_view bytes);

/// Refuses "-" for every option of the commands below `app` that does not read standard input or
/// write standard output: it is never a file of that name.
void refuse_streams(CLI::App& app);

}  // namespace mocapress::cli
