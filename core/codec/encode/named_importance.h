// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mocapress {

class Skeleton;
struct Importance;

/// Importance before the skeleton is known: by the names of body parts and joints.
struct NamedImportance {
  // By "feet" and the other body parts, or a joint, whose own factor goes before its part's; in the
  // order of the names, as set() keeps it.
  std::vector<std::pair<std::string, double>> factors;
  double contacts = 0;  // as Importance has it

  /// 1 unless it was set.
  double factor(std::string_view name) const;
  void set(const std::string& name, double factor);

  bool is_even() const { return factors.empty() && contacts == 0; }
  bool operator==(const NamedImportance&) const = default;
};

bool is_body_part(std::string_view name);

/// The joints of a body part, or the one joint of that name; empty: there is none.
std::vector<int> joints_named(const Skeleton& skeleton, const std::string& name);

/// For one skeleton. Body parts that it lacks are left out; throws Error for a joint it lacks.
Importance importance_for(const NamedImportance& named, const Skeleton& skeleton);

/// The reverse: a part by the factor most of its joints have, or that of its joint of the same
/// name; the others by their own.
NamedImportance named(const Importance& importance, const Skeleton& skeleton);

}  // namespace mocapress
