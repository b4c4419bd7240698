// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/codec/encode/named_importance.h"

namespace mocapress::cli {

/// What the user wants more care taken of.
struct ImportanceArguments {
  std::vector<std::string> words;  // "NAME=FACTOR"

  void add_options(CLI::App& command);

  /// Throws CLI::ValidationError when a factor is no number of 0 or more.
  NamedImportance named() const;

  /// Throws as named(), and when a name is neither part, joint nor "contacts".
  void require_names_of(const Skeleton& skeleton) const;
};

}  // namespace mocapress::cli
