// SPDX-License-Identifier: MIT
#include "core/report/markup.h"

#include <algorithm>
#include <cmath>

#include "core/base/number_text.h"

namespace mocapress {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:  // XML does not allow other control characters
        safe += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? '?' : c;
    }
  return safe;
}

std::string element(std::string_view tag, std::string_view attributes, std::string_view content) {
  std::string text = "<";
  text.append(tag);
  if (!attributes.empty() && attributes.front() != ' ') text += ' ';
  text.append(attributes).append(">").append(content).append("</").append(tag).append(">");
  return text;
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string fixed(double value, int decimals) {
  return fixed_text(value, decimals);
}

std::string px(double value) {
  return fixed(value, 1);
}

std::string format_significant(double value) {
  if (value == 0) return "0";
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  return fixed(value, std::clamp(decimals, 0, 3));
}

std::string format_shortest(double value) {
  std::string text = fixed(value, 4);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string ratio_text(double ratio) {
  return format_significant(ratio) + ":1";
}

}  // namespace mocapress
