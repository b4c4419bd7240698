// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

namespace mocapress {

/// The language of a report for people. Core's texts are English; a program with other languages
/// translates them. Tables and JSON for programs stay English.
struct ReportLanguage {
  std::string code = "en";                                           // as HTML's attribute lang
  std::function<std::string(const std::string& english)> translate;  // unset: English

  /// Returns a text in this language, with `values` in place of %1, %2 and so on.
  std::string operator()(const std::string& english,
                         std::initializer_list<std::string> values = {}) const;
};

}  // namespace mocapress
