// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <initializer_list>
#include <string>

namespace mocapress {

/// The language that a report is written in for people. Core's own texts are English; a program
/// that speaks others translates them. Tables and JSON for machines stay English.
struct ReportLanguage {
  std::string code = "en";                                           // as HTML's attribute lang
  std::function<std::string(const std::string& english)> translate;  // unset: English

  /// The text in this language, with `values` in place of %1, %2 and on.
  std::string operator()(const std::string& english,
                         std::initializer_list<std::string> values = {}) const;
};

}  // namespace mocapress
