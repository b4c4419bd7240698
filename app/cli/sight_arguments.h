// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "core/metrics/sight_limits.h"

namespace mocapress::cli {

/// Options for what viewers notice, and from what distance.
struct SightArguments {
  std::string limits_file;  // empty: read() uses its argument
  std::optional<double> distance_m;

  /// `otherwise` is a text for the help of --distance: the distance used if neither option gives
  /// one.
  void add_options(CLI::App& command, const std::string& otherwise);

  /// The limits of the file; without a file, `otherwise`. The distance is that of --distance, else
  /// that of the file, else that of `otherwise`. Throws InputError.
  SightLimits read(const SightLimits& otherwise = {}) const;
};

}  // namespace mocapress::cli
