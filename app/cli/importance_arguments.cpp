// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/importance_arguments.h"

#include "core/motion/body_part.h"

namespace mocapress::cli {
namespace {

constexpr const char* kOption = "--importance";
constexpr const char* kContacts = "contacts";

struct Wish {
  std::string name;
  double factor;
};

Wish parse(const std::string& word) {
  const std::size_t equals = word.find('=');
  double factor = 0;
  if (equals == std::string::npos || !CLI::detail::lexical_cast(word.substr(equals + 1), factor) ||
      !(factor >= 0))
    throw CLI::ValidationError(kOption, "expects NAME=FACTOR, FACTOR 0 or more: " + word);
  return {word.substr(0, equals), factor};
}

std::vector<int> joints_named(const Skeleton& skeleton, const std::string& name) {
  for (const BodyPart part : kBodyParts)
    if (name == mocapress::name(part)) return joints_of(skeleton, part);
  const int joint = skeleton.find(name);
  return joint < 0 ? std::vector<int>{} : std::vector{joint};
}

}  // namespace

void ImportanceArguments::add_options(CLI::App& command) {
  command
      .add_option(
          kOption, words,
          "Take more care of feet, hands, fingers, head, a joint, or of contacts (feet while "
          "they stand), at the cost of the rest")
      ->type_name("NAME=FACTOR,...")
      ->delimiter(',');
}

Importance ImportanceArguments::importance(const Skeleton& skeleton) const {
  Importance importance;
  for (const std::string& word : words) {
    const auto [name, factor] = parse(word);
    if (name == kContacts) {
      importance.contacts = factor;
      continue;
    }
    const std::vector<int> joints = joints_named(skeleton, name);
    if (joints.empty())
      throw CLI::ValidationError(kOption, "the skeleton has no part or joint named " + name);
    importance.joints.resize(static_cast<std::size_t>(skeleton.joint_count()), 1.0);
    for (const int joint : joints) importance.joints[static_cast<std::size_t>(joint)] = factor;
  }
  return importance;
}

}  // namespace mocapress::cli
