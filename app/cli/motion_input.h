// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress::cli {

/// Options for reading the source motion, shared by several commands.
struct MotionInput {
  std::optional<std::string> skeleton;
  ReadOptions options;

  void add_options(CLI::App& command);

  /// Adds the option of commands that measure.
  void add_character_option(CLI::App& command);

  /// Adds the option of commands that use tracks.
  void add_tracks_option(CLI::App& command);

  /// All files that are read along with `path`.
  std::vector<std::filesystem::path> files(const std::string& path) const;

  /// Reads the file and reports repairs and guesses on standard error.
  MotionFile read_file(const std::string& path) const;
  Motion read(const std::string& path) const { return read_file(path).motion; }
};

/// Options for writing a motion file, which replace the values of its source.
struct MotionOutput {
  WriteOptions options;

  void add_options(CLI::App& command);
};

void print_warnings(const Warnings& warnings);

}  // namespace mocapress::cli
