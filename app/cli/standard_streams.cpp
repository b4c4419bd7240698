// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/standard_streams.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/base/error.h"

namespace mocapress::cli {
namespace {

/// True for options that accept "-".
bool takes_stream(const std::string& command, const std::string& option) {
  return (command == "compress" && (option == "input" || option == "--output")) ||
         (command == "decompress" && option == "--output");
}

}  // namespace

std::string read_standard_input() {
  std::string bytes;
  char piece[1 << 16];
  while (const std::size_t count = std::fread(piece, 1, sizeof piece, stdin))
    bytes.append(piece, count);
  if (std::ferror(stdin)) throw InputError("standard input", 0, 0, std::strerror(errno));
  return bytes;
}

void write_standard_output(std::string_view bytes) {
  const bool is_written = std::fwrite(bytes.data(), 1, bytes.size(), stdout) == bytes.size() &&
                          std::fflush(stdout) == 0;
  if (!is_written)
    throw WriteError(std::string("standard output: cannot be written: ") + std::strerror(errno));
}

void refuse_streams(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands({})) {
    refuse_streams(*command);
    for (CLI::Option* option : command->get_options())
      if (option->get_items_expected_max() > 0 &&
          !takes_stream(command->get_name(), option->get_name()))
        option->check(CLI::Validator(
            [](std::string& text) {
              return text == kStandardStream
                         ? "- is not read or written here: name a file (./- is a file named -)"
                         : std::string();
            },
            ""));
  }
}

}  // namespace mocapress::cli
