// SPDX-License-Identifier: MIT
#include "core/formats/text_writer.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/base/number_text.h"

namespace mocapress {

void append_number(std::string& text, double value, int decimals) {
  const std::string fixed = fixed_text(value, decimals);
  std::string_view digits = fixed;
  if (digits.find('.') != digits.npos) {
    digits = digits.substr(0, digits.find_last_not_of('0') + 1);
    if (digits.ends_with('.')) digits.remove_suffix(1);
  }
  text += digits == "-0" ? "0" : digits;
}

int length_decimals(double cm_per_unit) {
  return std::clamp(6 + static_cast<int>(std::floor(std::log10(cm_per_unit))), 4, 12);
}

void append_vector(std::string& text, const Eigen::Vector3d& vector, int decimals) {
  for (const double value : vector) {
    text += ' ';
    append_number(text, value, decimals);
  }
}

std::string counted(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

std::string as_word(const std::string& name, const std::string& forbidden) {
  std::string word = name.empty() ? "_" : name;
  for (char& c : word)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7F || forbidden.find(c) != forbidden.npos)
      c = '_';
  return word;
}

std::string unique_word(const std::string& name, std::unordered_set<std::string>& taken) {
  std::string candidate = name;
  for (int n = 2; !taken.insert(candidate).second; ++n) candidate = name + '_' + std::to_string(n);
  return candidate;
}

}  // namespace mocapress
