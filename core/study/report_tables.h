// SPDX-License-Identifier: MIT
// The tables of a report. Each is empty if the study has no data for it.

#pragma once

#include <string>

#include "core/report/report_language.h"
#include "core/study/results.h"

namespace mocapress {

/// The error at which single numbers are compared: the one at which most clips have a size, in the
/// leading series or else in all; of several, 0.5 cm, up to which the paper saw no artifact.
double headline_eps_cm(const Results& results);

/// The title of a series in the language of the report.
std::string title_of(const ReportLanguage& say, const Series& series);

/// The mean ratio of each series at equal errors.
std::string mean_size_table(const ReportLanguage& say, const Results& results);

/// Sizes laid out as in the paper's Table 1, beside its figures where it has some.
std::string size_table(const ReportLanguage& say, const Results& results);

/// Times laid out as in the paper's Table 2.
std::string time_table(const ReportLanguage& say, const Results& results);

/// The sliding of planted feet, at the coefficient ratio of the paper's video or the ratio nearest
/// to it.
std::string footskate_table(const ReportLanguage& say, const Results& results);

/// Every clip's ratios at headline_eps_cm().
std::string clip_table(const ReportLanguage& say, const Results& results);

/// Compressions that failed, with the reason, and targets that were missed.
std::string failure_table(const ReportLanguage& say, const Results& results);

/// Rotation errors (degrees) of each clip's joints, head and hands, for each series at one target:
/// the ratio nearest to the paper's video, else the error nearest to headline_eps_cm(). Empty
/// without measurements.
std::string angle_table(const ReportLanguage& say, const Results& results);

/// The effect of holding the feet by IK at equal size: error, footskate and the speed of the knees,
/// clip by clip. Empty if no feet were held.
std::string held_feet_table(const ReportLanguage& say, const Results& results);

}  // namespace mocapress
