// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/correction_arguments.h"
#include "app/cli/importance_arguments.h"
#include "core/mocapress/settings.h"

namespace mocapress::cli {

/// A preset, and what is to be different: the options of `compress`.
struct PresetArguments {
  std::string preset = "gameplay";  // a name or a file
  std::string method;               // empty: the preset's
  std::optional<Coding> coding;
  std::optional<Weighting> weighting;
  std::optional<Target> target;
  std::optional<std::uint64_t> seed;
  std::optional<Effort> effort;
  std::optional<Ends> ends;
  std::optional<Loop> loop;
  ImportanceArguments importance;  // instead of the preset's, where anything is named
  CorrectionArguments correction;

  void add_options(CLI::App& command);

  /// Throws InputError where the preset cannot be read, CLI::ValidationError on what does not go
  /// together.
  Settings read() const;
};

}  // namespace mocapress::cli
