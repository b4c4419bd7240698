// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/sight_arguments.h"
#include "core/codec/encode/options/importance.h"
#include "core/mocapress/settings.h"

namespace mocapress::cli {

/// Options of the IK correction.
struct CorrectionArguments {
  std::string ratio;  // r_IK, "auto", or empty: no correction
  std::vector<std::string> effectors;
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  void add_options(CLI::App& command);

  /// Requires --ik.
  CorrectionSettings settings() const;
};

/// Options of the importances.
struct ImportanceArguments {
  std::vector<std::string> words;  // "NAME=FACTOR"

  void add_options(CLI::App& command);

  /// Throws CLI::ValidationError if a factor is negative or not a number.
  NamedImportance named() const;

  /// Throws like named(), and when a name is neither a body part, a joint nor "contacts".
  void require_names_of(const Skeleton& skeleton) const;
};

/// Adds --importance-range, whose ranges are stored in `ranges`.
void add_range_option(CLI::App& command, std::vector<ImportantRange>& ranges);

/// Adds the options that set a target, at most one of which may be given; `choose` receives it.
void add_target_options(CLI::App& command, const std::string& title,
                        const std::function<void(const Target&)>& choose);

/// A preset and changes to it, for `compress` and `batch`.
struct PresetArguments {
  std::string preset;  // name or file; empty: none
  std::string method;  // empty: the preset's
  std::optional<Coding> coding;
  std::optional<Weighting> weighting;
  std::optional<Target> target;
  std::optional<std::uint64_t> seed;
  std::optional<Effort> effort;  // read() leaves a draft to the caller: Settings
                                 // cannot hold it
  std::optional<Ends> ends;
  std::optional<Loop> loop;
  ImportanceArguments importance;  // replaces the preset's importances if any is named
  CorrectionArguments correction;
  SightArguments sight;

  /// `with_drafts`: --effort also accepts "draft".
  void add_options(CLI::App& command, bool with_drafts);

  /// Throws InputError if the preset cannot be read, CLI::ValidationError for options that exclude
  /// each other.
  Settings read() const;
};

}  // namespace mocapress::cli
