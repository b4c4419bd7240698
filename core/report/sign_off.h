// SPDX-License-Identifier: MIT
// The report by which a set of clips is signed off: each clip with its verdict, worst frame and
// notes, who said so and when, and how many are still to be reviewed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/visibility.h"
#include "core/report/report_language.h"
#include "core/report/report_stamp.h"
#include "core/report/review.h"

namespace mocapress {

/// The result of a clip's last compression, as far as a sign-off shows it.
struct SignOffFigures {
  double ratio = 0;
  std::size_t bytes = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::optional<int> worst_frame;  // where max_cm is
  std::string worst_point;         // likewise; empty: unknown
  std::optional<Sight> sight;
  SightLimits limits;                // limits by which `sight` was judged
  std::optional<std::string> stale;  // why the figures are not those of the clip today
};

struct SignOffClip {
  std::string name;
  std::string path;           // absolute; its links lead there
  std::string take;           // in a file with several; else empty
  double sample_rate_hz = 0;  // 0: unknown
  ClipReview review;
  std::string source_hash;  // hashes of the clip's files and settings today, for stale_reason()
  std::string settings_hash;
  std::optional<SignOffFigures> figures;  // unset: never compressed
  std::string problem;                    // why it cannot be read or compressed; empty: it can
};

struct SignOff {
  std::string title;  // the project's name
  std::vector<SignOffClip> clips;
  ReportStamp stamp;
  ReportLanguage language;  // the pages' language; tables are English
};

/// Verdicts of clips, by what still applies.
struct SignOffCounts {
  std::size_t approved = 0;
  std::size_t rejected = 0;
  std::size_t stale = 0;    // verdicts that no longer apply
  std::size_t waiting = 0;  // clips without a verdict

  std::size_t reviewed() const { return approved + rejected; }
  bool operator==(const SignOffCounts&) const = default;
};

SignOffCounts count(const SignOff& report);

/// Screens get the style of other reports. Paper gets one that simple renderers of HTML understand,
/// such as Qt's, which makes the PDF.
enum class ReportMedium { Screen, Paper };

/// A page that needs nothing else, with a link to each clip, worst frame and note.
std::string sign_off_html(const SignOff& report, ReportMedium medium = ReportMedium::Screen);

/// A row a clip, as comma-separated values (RFC 4180).
std::string sign_off_csv(const SignOff& report);

}  // namespace mocapress
