// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/batch/row.h"

namespace mocapress {

/// Reasons to refuse a clip that was compressed without failure.
enum class Gate {
  Visible,     // an attentive viewer sees its error
  Borderline,  // an attentive viewer sees or may see its error
  Rejected,    // a reviewer rejected it, or its verdict is stale
  Damaged,     // its source is cut short or holds values that are not numbers
  Warning      // its reader repaired or guessed something
};

/// The name of a gate: "visible", "borderline", "rejected", "damaged" or "warning".
std::string_view name(Gate gate);

/// The gate with this name, if there is one.
std::optional<Gate> gate_named(std::string_view word);

/// The reason why the first of `gates` that applies refuses a clip that is done. Unset if none
/// applies.
std::optional<std::string> refusal(const BatchRow& row, const std::vector<Gate>& gates);

}  // namespace mocapress
