// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/study_settings.h"

namespace mocapress {

StudySettings usualStudySettings() {
  StudySettings settings;
  for (const char* method : {"closed-loop", "annealed", "standard", "haar", "pca", "subsample"})
    settings.methods << QLatin1String(method);
  for (const Target& target : usual_targets())
    (target.kind == Target::Kind::Ratio ? settings.ratios : settings.errors)
        .push_back(target.value);
  return settings;
}

StudyPlan planOf(const StudySettings& settings) {
  StudyPlan plan;
  std::vector<Target> targets;
  for (const double ratio : settings.ratios) targets.push_back({Target::Kind::Ratio, ratio});
  for (const double error : settings.errors) targets.push_back({Target::Kind::Error, error});
  for (const QString& clip : settings.clips) plan.clips.push_back({clip.toStdU16String(), targets});
  for (const QString& method : settings.methods) plan.methods.push_back(method.toStdString());
  if (!settings.skeleton.isEmpty()) plan.skeleton = settings.skeleton.toStdU16String();
  if (settings.ik_ratio) plan.ik_ratios = {*settings.ik_ratio};
  plan.settings.weighting = settings.weighting;
  return plan;
}

}  // namespace mocapress
