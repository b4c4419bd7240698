// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/batch/row.h"

namespace mocapress {

/// Reasons to refuse a clip although it is done.
enum class Gate {
  Visible,     // an attentive viewer sees its error
  Borderline,  // an attentive viewer sees or may see its error
  Rejected,    // a reviewer rejected it, or the verdict is stale
  Damaged,     // its file is cut short, or holds values that are no numbers
  Warning      // its reader repaired or guessed something
};

/// "visible", "borderline", "rejected", "damaged", "warning".
std::string_view name(Gate gate);

/// The gate of this name; unset if there is none.
std::optional<Gate> gate_named(std::string_view word);

/// The reason of the first gate that refuses a clip that is done; unset if none does.
std::optional<std::string> refusal(const BatchRow& row, const std::vector<Gate>& gates);

}  // namespace mocapress
