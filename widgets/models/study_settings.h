// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <vector>

#include "core/study/plan.h"

namespace mocapress {

/// What the user asks of a study.
struct StudySettings {
  QStringList clips;    // files
  QString skeleton;     // .asf of clips that have none beside them; empty: none
  QStringList methods;  // names of compression_methods()
  std::vector<double> ratios;
  std::vector<double> errors;      // eps_x, cm
  std::optional<double> ik_ratio;  // set: annealed also with the feet held
  Weighting weighting = Weighting::Surface;

  bool operator==(const StudySettings&) const = default;
};

/// The methods most worth comparing, at usual_targets().
StudySettings usualStudySettings();

StudyPlan planOf(const StudySettings& settings);

}  // namespace mocapress
