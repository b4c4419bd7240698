// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/importance_arguments.h"

#include "core/motion/skeleton.h"

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

NamedImportance ImportanceArguments::named() const {
  NamedImportance named;
  for (const std::string& word : words) {
    const auto [name, factor] = parse(word);
    if (name == kContacts)
      named.contacts = factor;
    else
      named.set(name, factor);
  }
  return named;
}

void ImportanceArguments::require_names_of(const Skeleton& skeleton) const {
  const NamedImportance wishes = named();
  for (const auto& [name, factor] : wishes.factors)
    if (joints_named(skeleton, name).empty())
      throw CLI::ValidationError(kOption, "the skeleton has no part or joint named " + name);
}

}  // namespace mocapress::cli
