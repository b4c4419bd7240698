// SPDX-License-Identifier: MIT
#include "core/batch/gate.h"

#include <algorithm>

namespace mocapress {
namespace {

bool is_refused_by(const BatchRow& row, Gate gate) {
  const std::optional<Seen> seen = row.measured ? row.measured->seen : std::nullopt;
  switch (gate) {
    case Gate::Visible:
      return seen && seen->sight() == Sight::Visible;
    case Gate::Borderline:
      return seen && seen->sight() != Sight::NotVisible;
    case Gate::Rejected:
      return row.review.verdict == Verdict::Rejected || stale_reason(row);
    case Gate::Warning:
      return !row.warnings.empty();
  }
  return false;
}

}  // namespace

std::string_view name(Gate gate) {
  constexpr std::string_view kNames[] = {"visible", "borderline", "rejected", "warning"};
  return kNames[static_cast<std::size_t>(gate)];
}

std::optional<Gate> gate_named(std::string_view word) {
  for (const Gate gate : {Gate::Visible, Gate::Borderline, Gate::Rejected, Gate::Warning})
    if (name(gate) == word) return gate;
  return std::nullopt;
}

bool is_refused(const BatchRow& row, const std::vector<Gate>& gates) {
  return row.done() &&
         std::ranges::any_of(gates, [&](Gate gate) { return is_refused_by(row, gate); });
}

}  // namespace mocapress
