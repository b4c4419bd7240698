// SPDX-License-Identifier: MIT
// Reviewers' verdicts as JSON and text, and the check whether they still apply.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/json_text.h"
#include "core/report/report_language.h"
#include "core/report/review.h"

namespace mocapress {

/// Writes a review as JSON, in the same form for projects, queues, journals and reports. Sets
/// "verdict", "note", "reviewer", "reviewed" (the time), "source_hash", "settings_hash" and "notes"
/// (to_json() of each) in `json`. Empty fields become null.
void put(Json& json, const ClipReview& review);

/// Reads what put() wrote. A missing key gives an empty field. Throws the JSON library's exceptions
/// for a value of another type.
ClipReview review_from(const Json& json);

/// Convert notes on frames to JSON and back: objects of "frame", "last_frame", "joint", "text",
/// "reviewer", "time", "place_cm" (three numbers), "source_hash" and "settings_hash".
Json to_json(const std::vector<FrameNote>& notes);
std::vector<FrameNote> frame_notes_from(const Json& json);

/// The frame of a note, or its range, as people read it: "12", or "12" and "40" joined by an en
/// dash.
std::string frames_text(const FrameNote& note);

/// Describes a note: "frame 12, lfoot: slides (ana, 2026-11-27; stale: the settings changed)".
std::string note_text(const FrameNote& note, const std::optional<std::string>& stale_reason = {},
                      const ReportLanguage& say = {});

/// Returns the reason why a verdict does not apply to a source file and settings with these hashes:
/// "the clip's file changed", "the settings changed", or that the verdict has no hashes. Unset if
/// it applies or there is none. `source_hash` is InputStamp::source, `settings_hash` comes from
/// settings_hash() (both in core/batch/row.h).
std::optional<std::string> stale_reason(const ClipReview& review, std::string_view source_hash,
                                        std::string_view settings_hash);

/// Returns the reason why a note no longer applies. A note without hashes always applies.
std::optional<std::string> stale_reason(const FrameNote& note, std::string_view source_hash,
                                        std::string_view settings_hash);

/// Describes a verdict: "approved by ana, 2026-11-26; stale: the settings changed". Empty without a
/// verdict.
std::string verdict_text(const ClipReview& review, const std::optional<std::string>& stale_reason,
                         const ReportLanguage& say = {});

}  // namespace mocapress
