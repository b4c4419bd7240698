// SPDX-License-Identifier: MIT
#include "core/batch/gate.h"

#include <algorithm>

#include "core/base/names_all.h"
#include "core/formats/value_repair.h"

namespace mocapress {
namespace {

std::optional<std::string> refusal_by(const BatchRow& row, Gate gate) {
  const Seen seen = row.measured ? row.measured->seen : Seen();
  const Sight sight = seen.sight();
  switch (gate) {
    case Gate::Visible:
      if (sight != Sight::Visible) return std::nullopt;
      return std::string(name(sight)) + ": " + seen.reason;
    case Gate::Borderline:
      if (sight == Sight::NotVisible) return std::nullopt;
      return std::string(name(sight)) + ": " + seen.reason;
    case Gate::Rejected:
      if (const auto stale = stale_reason(row)) return "stale verdict: " + *stale;
      if (row.review.verdict == Verdict::Rejected) return "rejected";
      return std::nullopt;
    case Gate::Damaged:
      if (const auto found = std::ranges::find_if(row.warnings, &tells_of_damage);
          found != row.warnings.end())
        return "damaged: " + *found;
      return std::nullopt;
    case Gate::Warning:
      if (!row.warnings.empty()) return "warning: " + row.warnings.front();
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::string_view name(Gate gate) {
  constexpr std::string_view kNames[] = {"visible", "borderline", "rejected", "damaged", "warning"};
  static_assert(names_all<Gate>(kNames));
  return kNames[static_cast<std::size_t>(gate)];
}

std::optional<Gate> gate_named(std::string_view word) {
  for (const Gate gate :
       {Gate::Visible, Gate::Borderline, Gate::Rejected, Gate::Damaged, Gate::Warning})
    if (name(gate) == word) return gate;
  return std::nullopt;
}

std::optional<std::string> refusal(const BatchRow& row, const std::vector<Gate>& gates) {
  if (!row.done()) return std::nullopt;
  for (const Gate gate : gates)
    if (std::optional<std::string> reason = refusal_by(row, gate)) return reason;
  return std::nullopt;
}

}  // namespace mocapress
