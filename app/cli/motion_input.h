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

  /// Adds --character, for commands that measure errors.
  void add_character_option(CLI::App& command);

  /// Adds --tracks, for commands that compress or measure scalar tracks.
  void add_tracks_option(CLI::App& command);

  /// All files that are read along with `path`.
  std::vector<std::filesystem::path> files(const std::string& path) const;

  /// Reads the file and reports repairs and guesses on standard error.
  MotionFile read_file(const std::string& path) const;
  Motion read(const std::string& path) const { return read_file(path).motion; }
};

/// Options for writing a motion file; each one given overrides what the source file states.
struct MotionOutput {
  WriteOptions options;

  void add_options(CLI::App& command);
};

void print_warnings(const Warnings& warnings);

}  // namespace mocapress::cli
