// SPDX-License-Identifier: MIT
// The sign-off: a report on a set of clips that reviewers approve or reject. Lists each clip with
// its verdict, worst frame and notes, who decided and when, and tells how many clips are still to
// be reviewed.
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

/// Results of a clip's last compression that a sign-off shows.
struct SignOffFigures {
  double ratio = 0;
  std::size_t bytes = 0;
  double eps_cm = 0;
  double max_cm = 0;
  std::optional<int> worst_frame;  // frame of the largest error
  std::string worst_point;         // point of the largest error; empty: unknown
  std::optional<Sight> sight;
  SightLimits limits;                // limits by which `sight` was judged
  std::optional<std::string> stale;  // why these results no longer apply
};

struct SignOffClip {
  std::string name;
  std::string path;           // absolute path, to which the links lead
  std::string take;           // for a file with several takes; else empty
  double sample_rate_hz = 0;  // 0: unknown
  ClipReview review;
  std::string source_hash;  // hashes of the clip's files and settings today, for stale_reason()
  std::string settings_hash;
  std::optional<SignOffFigures> figures;  // unset: it was never compressed
  std::string problem;                    // why it cannot be read or compressed; empty: no problem
};

struct SignOff {
  std::string title;  // the project's name
  std::vector<SignOffClip> clips;
  ReportStamp stamp;
  ReportLanguage language;  // language of the page; tables for programs are English
};

/// Counts of clips by their verdicts.
struct SignOffCounts {
  std::size_t approved = 0;
  std::size_t rejected = 0;
  std::size_t stale = 0;    // verdicts that no longer apply
  std::size_t waiting = 0;  // clips without a verdict

  std::size_t reviewed() const { return approved + rejected; }
  bool operator==(const SignOffCounts&) const = default;
};

SignOffCounts count(const SignOff& report);

/// Screen: the style of other reports. Paper: a style for simple HTML renderers, such as Qt's,
/// which makes the PDF.
enum class ReportMedium { Screen, Paper };

/// Makes a page that needs no other file, with a link to each clip, worst frame and note.
std::string sign_off_html(const SignOff& report, ReportMedium medium = ReportMedium::Screen);

/// Makes comma-separated values (RFC 4180) with a row for each clip.
std::string sign_off_csv(const SignOff& report);

}  // namespace mocapress
