// SPDX-License-Identifier: MIT
#include "core/codec/encode/named_importance.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/codec/encode/importance.h"
#include "core/motion/body_part.h"

namespace mocapress {
namespace {

/// The factor most joints have; of equally frequent ones the least.
double usual_factor(const std::vector<double>& factors, const std::vector<int>& joints) {
  std::map<double, int> counts;
  for (const int joint : joints) ++counts[factors[static_cast<std::size_t>(joint)]];
  return std::max_element(counts.begin(), counts.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

double NamedImportance::factor(std::string_view name) const {
  const auto found = std::find_if(factors.begin(), factors.end(),
                                  [&](const auto& one) { return one.first == name; });
  return found == factors.end() ? 1 : found->second;
}

void NamedImportance::set(const std::string& name, double factor) {
  const auto place =
      std::lower_bound(factors.begin(), factors.end(), name,
                       [](const auto& one, const std::string& text) { return one.first < text; });
  if (place != factors.end() && place->first == name)
    place->second = factor;
  else
    factors.insert(place, {name, factor});
}

bool is_body_part(std::string_view name) {
  return std::any_of(std::begin(kBodyParts), std::end(kBodyParts),
                     [&](BodyPart part) { return mocapress::name(part) == name; });
}

std::vector<int> joints_named(const Skeleton& skeleton, const std::string& name) {
  for (const BodyPart part : kBodyParts)
    if (name == mocapress::name(part)) return joints_of(skeleton, part);
  const int joint = skeleton.find(name);
  return joint < 0 ? std::vector<int>{} : std::vector{joint};
}

Importance importance_for(const NamedImportance& named, const Skeleton& skeleton) {
  Importance importance{.joints = {}, .contacts = named.contacts};
  std::vector<double> factors(static_cast<std::size_t>(skeleton.joint_count()), 1.0);
  for (const bool parts : {true, false})
    for (const auto& [name, factor] : named.factors) {
      if (is_body_part(name) != parts) continue;
      const std::vector<int> joints = joints_named(skeleton, name);
      if (joints.empty() && !parts) throw Error("the skeleton has no joint named " + name);
      for (const int joint : joints) factors[static_cast<std::size_t>(joint)] = factor;
    }
  const bool even =
      std::all_of(factors.begin(), factors.end(), [](double factor) { return factor == 1; });
  if (!even) importance.joints = std::move(factors);
  return importance;
}

NamedImportance named(const Importance& importance, const Skeleton& skeleton) {
  NamedImportance named{.factors = {}, .contacts = importance.contacts};
  if (importance.joints.empty()) return named;
  std::vector<double> covered(importance.joints.size(), 1.0);
  for (const BodyPart part : kBodyParts) {
    const std::vector<int> joints = joints_of(skeleton, part);
    if (joints.empty()) continue;
    // A joint of the part's own name can be spoken of by that alone.
    const int namesake = skeleton.find(std::string(name(part)));
    const bool has_namesake = std::find(joints.begin(), joints.end(), namesake) != joints.end();
    const double factor = has_namesake ? importance.joints[static_cast<std::size_t>(namesake)]
                                       : usual_factor(importance.joints, joints);
    if (factor == 1) continue;
    named.set(std::string(name(part)), factor);
    for (const int joint : joints) covered[static_cast<std::size_t>(joint)] = factor;
  }
  for (std::size_t j = 0; j < covered.size(); ++j)
    if (importance.joints[j] != covered[j])
      named.set(skeleton.joint(static_cast<int>(j)).name, importance.joints[j]);
  return named;
}

}  // namespace mocapress
