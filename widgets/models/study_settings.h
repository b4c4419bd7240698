// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <vector>

#include "core/study/plan.h"

namespace mocapress {

/// The user's choices for a study.
struct StudySettings {
  QStringList clips;    // files
  QString skeleton;     // .asf for clips without one beside them; empty: none
  QStringList methods;  // names as in compression_methods()
  std::vector<double> ratios;
  std::vector<double> errors;      // eps_x, cm
  std::optional<double> ik_ratio;  // if set, the annealed method also runs with held feet
  Weighting weighting = Weighting::Surface;

  bool operator==(const StudySettings&) const = default;
};

/// Default settings: the methods most worth comparing, at usual_targets().
StudySettings usualStudySettings();

StudyPlan planOf(const StudySettings& settings);

}  // namespace mocapress
