// SPDX-License-Identifier: MIT
// The tables of a report. A table is empty if the study has no data for it.

#pragma once

#include <string>

#include "core/report/report_language.h"
#include "core/study/results.h"

namespace mocapress {

/// The error at which the report compares methods by single numbers: the one at which the leading
/// series, or else all series together, have a size for most clips. If there are several, the
/// first of a fixed list that starts with 0.5 cm, up to which the paper saw no artifacts.
double headline_eps_cm(const Results& results);

/// The title of a series in the report's language.
std::string title_of(const ReportLanguage& say, const Series& series);

/// Mean ratios of all series at equal errors.
std::string mean_size_table(const ReportLanguage& say, const Results& results);

/// Sizes in the form of the paper's Table 1, beside the paper's values for clips that it has.
std::string size_table(const ReportLanguage& say, const Results& results);

/// Times in the form of the paper's Table 2.
std::string time_table(const ReportLanguage& say, const Results& results);

/// The sliding of planted feet, in two tables: at the coefficient ratio and at the compression
/// ratio that are nearest to 30, the coefficient ratio of the paper's video.
std::string footskate_table(const ReportLanguage& say, const Results& results);

/// The ratios of every clip at headline_eps_cm().
std::string clip_table(const ReportLanguage& say, const Results& results);

/// Compressions that failed, with the reason, and those that missed their target.
std::string failure_table(const ReportLanguage& say, const Results& results);

/// Rotation errors (degrees) of each clip's joints, head and hands for each series. All are at one
/// target: the compression ratio nearest to 30, the coefficient ratio of the paper's video, or else
/// the error nearest to headline_eps_cm(). Empty without measurements.
std::string angle_table(const ReportLanguage& say, const Results& results);

/// The effect of holding the feet by IK at equal size, clip by clip: error, footskate and the speed
/// of the knees. Empty if no feet were held.
std::string held_feet_table(const ReportLanguage& say, const Results& results);

}  // namespace mocapress
