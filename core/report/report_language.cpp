// SPDX-License-Identifier: MIT
#include "core/report/report_language.h"

namespace mocapress {

std::string ReportLanguage::operator()(const std::string& english,
                                       std::initializer_list<std::string> values) const {
  const std::string pattern = translate ? translate(english) : english;
  std::string text;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const bool is_place = pattern[i] == '%' && i + 1 < pattern.size() && pattern[i + 1] > '0' &&
                          static_cast<std::size_t>(pattern[i + 1] - '0') <= values.size();
    if (is_place)
      text += values.begin()[pattern[++i] - '1'];
    else
      text += pattern[i];
  }
  return text;
}

}  // namespace mocapress
