// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/base/number_text.h"
#include "core/codec/methods/compression_method.h"

namespace mocapress::cli {

/// An option whose words are the names of enum values, as given by name().
template <typename Enum>
CLI::CheckedTransformer one_of(std::initializer_list<Enum> values) {
  std::map<std::string, Enum> words;
  std::string shown;  // list shown in the help
  for (const Enum value : values) {
    words.emplace(name(value), value);
    shown.append(shown.empty() ? "" : "|").append(name(value));
  }
  CLI::CheckedTransformer transformer(words, CLI::ignore_case);
  transformer.description(shown);
  return transformer;
}

/// Checks for a number above 0. CLI11's own check prints an upper limit of 309 digits.
inline CLI::Validator number_above_0() {
  return CLI::Validator(
      [](std::string& text) {
        return number_in(text).value_or(0) > 0 ? "" : text + " is not a number above 0";
      },
      "POSITIVE");
}

/// Checks for a method's name.
inline CLI::IsMember one_of_the_methods() {
  std::vector<std::string> names;
  for (const CompressionMethod& compression_method : compression_methods())
    names.emplace_back(compression_method.name);
  return CLI::IsMember(names, CLI::ignore_case);
}

}  // namespace mocapress::cli
