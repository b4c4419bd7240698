// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/batch/preset.h"
#include "core/codec/encode/correction_encoder.h"

namespace mocapress::cli {

/// What the user asks of the IK correction.
struct CorrectionArguments {
  std::string ratio;  // r_IK, "auto", or empty: no correction
  std::vector<std::string> effectors;
  IkSolver solver = IkSolver::NearestPose;
  CorrectAt at = CorrectAt::EveryFrame;

  void add_options(CLI::App& command);

  /// Unset without --ik. Throws CLI::ValidationError when an effector is no joint of the skeleton.
  std::optional<CorrectionOptions> options(const Skeleton& skeleton) const;

  /// The same before there is a skeleton; wants --ik.
  PresetCorrection of_preset() const;
};

}  // namespace mocapress::cli
