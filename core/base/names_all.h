// SPDX-License-Identifier: MIT
// Checks at compile time that a table of names was extended with its enumeration.
#pragma once

#include <cstddef>
#include <string_view>

namespace mocapress {

/// True if the value is an enumerator. In __PRETTY_FUNCTION__, gcc and clang print any other value
/// as a cast: (Kind)7.
template <auto kValue>
consteval bool is_enumerator() {
#ifdef __GNUC__
  constexpr std::string_view kBefore = "kValue = ";
  const std::string_view function = __PRETTY_FUNCTION__;
  return function[function.find(kBefore) + kBefore.size()] != '(';
#else
  return true;
#endif
}

/// True if a table indexed by an enumeration has exactly one name for each of its values.
template <typename Enumeration, typename Name, std::size_t kCount>
consteval bool names_all(const Name (&)[kCount]) {
#ifdef __GNUC__
  return is_enumerator<static_cast<Enumeration>(kCount - 1)>() &&
         !is_enumerator<static_cast<Enumeration>(kCount)>();
#else
  return true;
#endif
}

}  // namespace mocapress
