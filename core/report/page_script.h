// SPDX-License-Identifier: MIT
// Texts and values in the scripts of pages. Neither < nor & occurs in them: pages are XML, too.
#pragma once

#include <initializer_list>
#include <span>
#include <string>

#include "core/base/json_text.h"
#include "core/report/report_language.h"

namespace mocapress {

/// Writes JSON for a <script>, without characters that could end it.
std::string in_script(const Json& json);

/// A script that defines say(text, ...values) for the page's other scripts: each text of `lists` in
/// the page's language, with the values in place of %1 and on.
std::string say_script(const ReportLanguage& say,
                       std::initializer_list<std::span<const char* const>> lists);

}  // namespace mocapress
