// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"

namespace mocapress::cli {

/// How to read the source motion of a command: the options several commands share.
struct MotionInput {
  std::optional<std::string> skeleton;
  ReadOptions options;

  void add_options(CLI::App& command);

  /// Of commands that measure.
  void add_character_option(CLI::App& command);

  /// Of commands that look at tracks.
  void add_tracks_option(CLI::App& command);

  /// All files that reading `path` reads.
  std::vector<std::filesystem::path> files(const std::string& path) const;

  /// Reads the file and says on standard error what was repaired or guessed.
  MotionFile read_file(const std::string& path) const;
  Motion read(const std::string& path) const { return read_file(path).motion; }
};

/// How to write a motion file: what several commands ask of it in place of what its source had.
struct MotionOutput {
  WriteOptions options;

  void add_options(CLI::App& command);
};

void print_warnings(const Warnings& warnings);

}  // namespace mocapress::cli
