// SPDX-License-Identifier: MIT
// Verdicts of reviewers: what exactly was reviewed, and whether that still stands.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/json_text.h"
#include "core/report/review.h"

namespace mocapress {

/// The JSON form of a review, the same in projects, queues, journals and reports: "verdict",
/// "note", "reviewer", "reviewed" (the time), "source_hash" and "settings_hash" are set in `json`.
/// A field that is empty is null.
void put(Json& json, const ClipReview& review);

/// The inverse; keys that are left out are empty. Throws like the JSON library does for a value
/// that is not a text.
ClipReview review_from(const Json& json);

/// Why a verdict does not hold for a source file and settings, of which these are the hashes: "the
/// clip's file changed", "the settings changed", or that it was never bound to any. Unset: it
/// holds, or there is no verdict. `source_hash` is InputStamp::source, `settings_hash` what
/// settings_hash() gives (both in core/batch/row.h).
std::optional<std::string> stale_reason(const ClipReview& review, std::string_view source_hash,
                                        std::string_view settings_hash);

/// "approved by ana, 2026-11-26; stale: the settings changed". Empty: there is no verdict.
std::string verdict_text(const ClipReview& review, const std::optional<std::string>& stale_reason);

/// The verdict that counts: none where it is stale.
Verdict valid_verdict(const ClipReview& review, std::string_view source_hash,
                      std::string_view settings_hash);

}  // namespace mocapress
