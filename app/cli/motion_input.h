// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/formats/motion_file.h"

namespace mocapress::cli {

/// How to read the source motion of a command: the options several commands share.
struct MotionInput {
  std::optional<std::string> skeleton;
  ReadOptions options;

  void add_options(CLI::App& command);

  /// Reads the file and says on standard error what was repaired or guessed.
  Motion read(const std::string& path) const;
};

void print_warnings(const Warnings& warnings);

}  // namespace mocapress::cli
