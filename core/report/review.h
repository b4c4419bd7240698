// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mocapress {

/// A reviewer's decision about a clip.
enum class Verdict { None, Approved, Rejected };

/// Returns "approved", "rejected" or an empty text.
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

/// The verdict with this name; None for any other word.
constexpr Verdict verdict_named(std::string_view word) {
  for (const Verdict verdict : {Verdict::Approved, Verdict::Rejected})
    if (name(verdict) == word) return verdict;
  return Verdict::None;
}

/// A reviewer's note on a frame of a clip. The hashes identify the clip and settings that were
/// reviewed, as in ClipReview.
struct FrameNote {
  int frame = 0;                       // the first frame is 0
  std::optional<int> last_frame = {};  // last frame of a range; unset: a single frame
  std::string joint = {};              // name of a joint; empty: the whole figure
  std::string text = {};
  std::string reviewer = {};
  std::string time = {};                               // ISO 8601, UTC
  std::optional<std::array<double, 3>> place_cm = {};  // in world space; unset: at the joint
  std::string source_hash = {};
  std::string settings_hash = {};

  bool operator==(const FrameNote&) const = default;
};

/// A reviewer's verdict about a clip, with hashes that identify what was reviewed. It goes with the
/// clip into every report; stale_reason() in core/report/verdict.h tells whether it still applies.
struct ClipReview {
  Verdict verdict = Verdict::None;
  std::string note = {};
  std::string reviewer = {};
  std::string time = {};              // ISO 8601, UTC: "2026-11-26T14:05:00Z"
  std::string source_hash = {};       // hash of the reviewed source; empty: unknown
  std::string settings_hash = {};     // hash of the settings; empty: unknown
  std::vector<FrameNote> notes = {};  // in the order of their frames

  bool operator==(const ClipReview&) const = default;
};

}  // namespace mocapress
