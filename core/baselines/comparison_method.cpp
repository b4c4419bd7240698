// SPDX-License-Identifier: MIT
#include "core/baselines/comparison_method.h"

#include <algorithm>
#include <array>

#include "core/baselines/arikan.h"
#include "core/baselines/quaternion.h"

namespace mocapress {

std::span<const ComparisonMethod* const> comparison_methods() {
  static const std::array kMethods{&pca_method(), &subsample_method(), &quaternion_method(),
                                   &liu_mcmillan_method(), &arikan_method()};
  return kMethods;
}

const ComparisonMethod* find_comparison_method(std::string_view name) {
  const auto methods = comparison_methods();
  const auto found = std::find_if(methods.begin(), methods.end(),
                                  [&](const auto* method) { return method->name() == name; });
  return found == methods.end() ? nullptr : *found;
}

}  // namespace mocapress
