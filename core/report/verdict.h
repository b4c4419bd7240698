// SPDX-License-Identifier: MIT
// Reviewers' verdicts, and the check whether they still apply.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/report/review.h"

namespace mocapress {

/// Writes a review as JSON, the same in projects, queues, journals and reports: sets "verdict",
/// "note", "reviewer", "reviewed" (the time), "source_hash" and "settings_hash" in `json`. Empty
/// fields become null.
void put(Json& json, const ClipReview& review);

/// The inverse of put(); missing keys give empty fields. Throws the JSON library's exceptions for a
/// value that is not a text.
ClipReview review_from(const Json& json);

/// The reason why a verdict does not apply to a source file and settings with these hashes: "the
/// clip's file changed", "the settings changed", or that it has no hashes. Unset: it applies, or
/// there is none. `source_hash` is InputStamp::source, `settings_hash` is from settings_hash()
/// (both in core/batch/row.h).
std::optional<std::string> stale_reason(const ClipReview& review, std::string_view source_hash,
                                        std::string_view settings_hash);

/// Text of a verdict: "approved by ana, 2026-11-26; stale: the settings changed". Empty without a
/// verdict.
std::string verdict_text(const ClipReview& review, const std::optional<std::string>& stale_reason);

/// The verdict that counts: None for a stale one.
Verdict valid_verdict(const ClipReview& review, std::string_view source_hash,
                      std::string_view settings_hash);

}  // namespace mocapress
