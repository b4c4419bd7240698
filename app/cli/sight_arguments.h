// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/metrics/sight_limits.h"

namespace mocapress::cli {

/// Options for what viewers notice, and from what distance.
struct SightArguments {
  std::string limits_file;  // empty: the limits given to read()
  std::optional<double> distance_m;

  /// `otherwise` ends the help of --distance: the distance if neither option states one.
  void add_options(CLI::App& command, const std::string& otherwise);

  /// The limits of the file, else `otherwise`, at the distance that was asked for, else the file's,
  /// else that of `otherwise`. Throws InputError.
  SightLimits read(const SightLimits& otherwise = {}) const;
};

}  // namespace mocapress::cli
