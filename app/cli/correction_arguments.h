// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

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

}  // namespace mocapress::cli
