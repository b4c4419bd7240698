// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/study/row.h"

namespace mocapress {

/// A row as one line of JSON without its end. The keys are those of `mocapress compress --json`
/// where they mean the same; null where a value does not apply.
std::string to_json_line(const StudyRow& row);

/// The inverse; unset on anything that is not a whole row.
std::optional<StudyRow> parse_row(std::string_view line);

/// All rows as a JSON array, one a line.
std::string rows_json(std::span<const StudyRow> rows);

/// The same columns as comma-separated values (RFC 4180, lines end with a line feed) under a header
/// line; empty where a value does not apply.
std::string rows_csv(std::span<const StudyRow> rows);

}  // namespace mocapress
