// SPDX-License-Identifier: MIT
// Guards tables of names against an enumerator that was added without a name.
#pragma once

#include <cstddef>
#include <string_view>

namespace mocapress {

/// True if the enumeration has this value: gcc and clang print any other as a cast, (Kind)7.
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

/// True if a table, which is indexed by the values of an enumeration, has a name for each.
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
