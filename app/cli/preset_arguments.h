// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/codec/encode/options/importance.h"
#include "core/mocapress/settings.h"

namespace mocapress::cli {

/// What the user asks of the IK correction.
struct CorrectionArguments {
  std::string ratio;  // r_IK, "auto", or empty: no correction
  std::vector<std::string> effectors;
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  void add_options(CLI::App& command);

  /// Wants --ik.
  CorrectionSettings settings() const;
};

/// What the user wants more care taken of.
struct ImportanceArguments {
  std::vector<std::string> words;  // "NAME=FACTOR"

  void add_options(CLI::App& command);

  /// Throws CLI::ValidationError when a factor is no number of 0 or more.
  NamedImportance named() const;

  /// Throws as named(), and when a name is neither part, joint nor "contacts".
  void require_names_of(const Skeleton& skeleton) const;
};

/// The options that set a target, of which a call may have one: `choose` gets it.
void add_target_options(CLI::App& command, const std::string& title,
                        const std::function<void(const Target&)>& choose);

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
