// SPDX-License-Identifier: MIT
// Texts and values for the scripts of pages. They contain neither < nor &, since pages are XML.
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "core/base/json_text.h"
#include "core/report/report_language.h"

namespace mocapress {

/// Writes JSON for use in a <script>. Escapes the characters <, > and &.
std::string in_script(const Json& json);

/// Makes a script that defines say(text, ...values) for the page's other scripts. say() translates
/// the texts of `lists` to the page's language, and puts the values in place of %1, %2 and so on.
std::string say_script(const ReportLanguage& say,
                       std::initializer_list<std::span<const char* const>> lists);

}  // namespace mocapress
