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

/// A clip, and the targets that each method compresses it to.
struct StudyClip {
  std::filesystem::path path;
  std::vector<Target> targets;
  ClipReview review = {};  // the verdict from a library, if it has one
};

/// A comparison of methods: each clip is compressed by each method to each of the clip's targets.
struct StudyPlan {
  std::vector<StudyClip> clips;
  std::vector<std::string> methods;               // names from compression_methods()
  std::optional<std::filesystem::path> skeleton;  // for clips without one beside them
  ReadOptions reading;
  Settings settings;              // for all compressions, except method, target and correction
  std::vector<double> ik_ratios;  // r_IK values at which "annealed" also runs with feet held
};

/// The ratios and errors (cm) that a study has by default.
std::vector<Target> usual_targets();

/// The targets at which the paper evaluated a clip: a grid of ratios that contains those of Table
/// 2, the coefficient ratio of the paper's video, and, for clips of Table 1, the errors of the
/// table's rows.
std::vector<Target> paper_targets(const std::filesystem::path& clip);

/// One compression of a plan. `clip` and `method` are indices into the plan's lists.
struct StudyJob {
  std::size_t clip;
  std::size_t method;
  Target target;
  std::optional<double> ik_ratio;  // unset: without IK correction
};

/// Lists all compressions of a plan, clip by clip and method by method. Leaves out targets that a
/// method does not support: comparison methods have no coefficient ratio. With the feet held, only
/// compression and coefficient ratios are targets, so that files of equal size are compared.
std::vector<StudyJob> jobs_of(const StudyPlan& plan);

}  // namespace mocapress
