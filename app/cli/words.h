// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <map>
#include <string>

namespace mocapress::cli {

/// The words for the values of an enum, as name() gives them.
template <typename Enum>
std::map<std::string, Enum> words(std::initializer_list<Enum> values) {
  std::map<std::string, Enum> words;
  for (const Enum value : values) words.emplace(name(value), value);
  return words;
}

}  // namespace mocapress::cli
