// SPDX-License-Identifier: MIT
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace mocapress {

/// What a reviewer decided about a clip.
enum class Verdict { None, Approved, Rejected };

/// "approved", "rejected"; empty: neither.
constexpr std::string_view name(Verdict verdict) {
  switch (verdict) {
    case Verdict::Approved:
      return "approved";
    case Verdict::Rejected:
      return "rejected";
    case Verdict::None:
      break;
  }
  return "";
}

/// The inverse; none where it is neither.
constexpr Verdict verdict_named(std::string_view word) {
  for (const Verdict verdict : {Verdict::Approved, Verdict::Rejected})
    if (name(verdict) == word) return verdict;
  return Verdict::None;
}

/// A reviewer's verdict about a clip, and what was reviewed. It goes with the clip into every
/// report; stale_reason() in core/report/verdict.h says whether it still holds.
struct ClipReview {
  Verdict verdict = Verdict::None;
  std::string note = {};
  std::string reviewer = {};
  std::string time = {};           // ISO 8601, UTC: "2026-11-26T14:05:00Z"
  std::string source_hash = {};    // of the bytes that were reviewed; empty: not known
  std::string settings_hash = {};  // of the settings they were compressed with; empty: not known

  bool operator==(const ClipReview&) const = default;
};

}  // namespace mocapress
