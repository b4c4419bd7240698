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

/// A clip and what each method is asked to make of it.
struct StudyClip {
  std::filesystem::path path;
  std::vector<Target> targets;
  ClipReview review = {};  // where a library has one
};

/// Every clip by every method at every target of the clip.
struct StudyPlan {
  std::vector<StudyClip> clips;
  std::vector<std::string> methods;               // names of compression_methods()
  std::optional<std::filesystem::path> skeleton;  // of clips that have none beside them
  ReadOptions reading;
  Settings settings;              // of each, but for its method, target and correction
  std::vector<double> ik_ratios;  // r_IK of "annealed" with the feet held, besides without
};

/// The ratios and the errors (cm) of a study of which nothing else was asked.
std::vector<Target> usual_targets();

/// The paper's evaluation of a clip: a grid of ratios that holds those of Table 2, the coefficient
/// ratio of its video, and for the clips of Table 1 the errors of their rows.
std::vector<Target> paper_targets(const std::filesystem::path& clip);

/// One compression of a plan, by its places there.
struct StudyJob {
  std::size_t clip;
  std::size_t method;
  Target target;
  std::optional<double> ik_ratio;  // unset: without IK correction
};

/// Clip by clip, method by method, in the order of the plan. What a method does not know is left
/// out: the comparison methods have no coefficient ratio. Feet are held at ratios only, which say
/// what is compared: the same size.
std::vector<StudyJob> jobs_of(const StudyPlan& plan);

}  // namespace mocapress
