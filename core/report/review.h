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

/// What a reviewer says about a clip, which goes with it into every report.
struct ClipReview {
  Verdict verdict = Verdict::None;
  std::string note;

  bool operator==(const ClipReview&) const = default;
};

}  // namespace mocapress
