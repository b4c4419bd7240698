// SPDX-License-Identifier: MIT
// The tables of a report. Each is empty when the study has nothing for it.

#pragma once

#include <string>

#include "core/study/results.h"

namespace mocapress {

/// The error at which series are compared when one number is wanted: 0.5 cm, up to which the paper
/// saw no artifact, or the nearest at which most of the study has a size.
double headline_eps_cm(const Results& results);

/// Mean ratio of each series at equal errors.
std::string mean_size_table(const Results& results);

/// As the paper's Table 1, its figures beside where it has some.
std::string size_table(const Results& results);

/// As the paper's Table 2.
std::string time_table(const Results& results);

/// How far feet slide while planted, at the coefficient ratio of the paper's video or the ratio
/// nearest to it.
std::string footskate_table(const Results& results);

/// Every clip's ratios at headline_eps_cm().
std::string clip_table(const Results& results);

/// What was not measured and why, and targets that were missed.
std::string failure_table(const Results& results);

/// By how many degrees each clip's joints, head and hands are turned, by each series at one target:
/// the ratio nearest to that of the paper's video, else the error nearest to headline_eps_cm().
/// Empty where nothing was measured.
std::string angle_table(const Results& results);

/// What holding the feet by IK does at one and the same size: error, footskate and the speed of the
/// knees, clip by clip. Empty where a study held none.
std::string held_feet_table(const Results& results);

}  // namespace mocapress
