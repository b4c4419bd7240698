// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

#include "core/codec/methods/compression_method.h"

namespace mocapress::cli {

/// One of the values of an enum, by the words name() gives them.
template <typename Enum>
CLI::CheckedTransformer one_of(std::initializer_list<Enum> values) {
  std::map<std::string, Enum> words;
  std::string shown;  // in the help
  for (const Enum value : values) {
    words.emplace(name(value), value);
    shown.append(shown.empty() ? "" : "|").append(name(value));
  }
  CLI::CheckedTransformer transformer(words, CLI::ignore_case);
  transformer.description(shown);
  return transformer;
}

/// The name of a method.
inline CLI::IsMember one_of_the_methods() {
  std::vector<std::string> names;
  for (const CompressionMethod& compression_method : compression_methods())
    names.emplace_back(compression_method.name);
  return CLI::IsMember(names, CLI::ignore_case);
}

}  // namespace mocapress::cli
