// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/batch/row.h"

namespace mocapress {

/// Reasons for which a clip that is done may still be refused.
enum class Gate {
  Visible,     // an attentive viewer sees its error
  Borderline,  // the same, or may see it
  Rejected,    // a reviewer rejected it, or the verdict is stale
  Warning      // its reader repaired or guessed something
};

/// "visible", "borderline", "rejected", "warning".
std::string_view name(Gate gate);

/// Unset when it is none of them.
std::optional<Gate> gate_named(std::string_view word);

/// Whether a clip that is done is refused by one of the gates.
bool is_refused(const BatchRow& row, const std::vector<Gate>& gates);

}  // namespace mocapress
