// SPDX-License-Identifier: MIT
#include "core/report/page_script.h"

#include <nlohmann/json.hpp>

namespace mocapress {

std::string in_script(const Json& json) {
  std::string text;
  for (const char letter : dumped(json))
    if (letter == '<' || letter == '>' || letter == '&')
      text += letter == '<' ? "\\u003c" : letter == '>' ? "\\u003e" : "\\u0026";
    else
      text += letter;
  return text;
}

std::string say_script(const ReportLanguage& say,
                       std::initializer_list<std::span<const char* const>> lists) {
  Json translated = Json::object();
  for (const auto texts : lists)
    for (const char* text : texts)
      if (const std::string said = say(text); said != text) translated[text] = said;
  return "const said = " + in_script(translated) +
         ";\nfunction say(text, ...values) {\n"
         "  return (said[text] || text).replace(/%(\\d)/g, (place, i) => values[i - 1]);\n}\n";
}

}  // namespace mocapress
