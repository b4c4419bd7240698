// SPDX-License-Identifier: MIT
#include "core/codec/methods/comparison_method.h"

#include <algorithm>

namespace mocapress {
namespace {

std::vector<const ComparisonMethod*>& added_methods() {
  static std::vector<const ComparisonMethod*> methods;
  return methods;
}

}  // namespace

std::span<const ComparisonMethod* const> comparison_methods() {
  return added_methods();
}

void add_comparison_methods(std::span<const ComparisonMethod* const> methods) {
  added_methods().insert(added_methods().end(), methods.begin(), methods.end());
}

const ComparisonMethod* find_comparison_method(std::string_view name) {
  const auto methods = comparison_methods();
  const auto found =
      std::ranges::find_if(methods, [&](const auto* method) { return method->name == name; });
  return found == methods.end() ? nullptr : *found;
}

}  // namespace mocapress
