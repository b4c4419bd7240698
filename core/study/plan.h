// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/motion_file.h"
#include "core/mocapress/settings.h"
#include "core/report/review.h"

namespace mocapress {

/// A clip, and the targets that each method gets for it.
struct StudyClip {
  std::filesystem::path path;
  std::vector<Target> targets;
  ClipReview review = {};  // given if a library has one
};

/// A comparison of methods: every clip by every method at every target of the clip.
struct StudyPlan {
  std::vector<StudyClip> clips;
  std::vector<std::string> methods;               // names of compression_methods()
  std::optional<std::filesystem::path> skeleton;  // for clips without one beside them
  ReadOptions reading;
  Settings settings;              // for each compression, except method, target and correction
  std::vector<double> ik_ratios;  // r_IK values at which "annealed" also runs with the feet held
};

/// The default ratios and errors (cm) of a study.
std::vector<Target> usual_targets();

/// The targets of the paper's evaluation of a clip: a grid of ratios that contains those of Table
/// 2, the coefficient ratio of its video, and for the clips of Table 1 the errors of their rows.
std::vector<Target> paper_targets(const std::filesystem::path& clip);

/// One compression of a plan, by its indices there.
struct StudyJob {
  std::size_t clip;
  std::size_t method;
  Target target;
  std::optional<double> ik_ratio;  // unset: without IK correction
};

/// All compressions, clip by clip and method by method in the order of the plan. Targets that a
/// method cannot take are left out: comparison methods have no coefficient ratio. Feet are held at
/// ratios only, so that files of the same size are compared.
std::vector<StudyJob> jobs_of(const StudyPlan& plan);

}  // namespace mocapress
