// SPDX-License-Identifier: MIT
#include "core/formats/take_choice.h"

#include <algorithm>
#include <cmath>

#include "core/base/printable.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

/// A list of the first few takes, short enough for a sentence.
std::string listed(const std::vector<TakeName>& takes, std::optional<std::size_t> without) {
  constexpr std::size_t kMost = 8;
  constexpr std::size_t kEnough = 80;  // bytes
  std::string text;
  std::size_t count = 0;
  std::size_t left = takes.size() - (without ? 1 : 0);
  for (std::size_t i = 0; i < takes.size() && count < kMost && text.size() < kEnough; ++i) {
    if (i == without) continue;
    ++count;
    text += (text.empty() ? "" : ", ") + shortened(takes[i].name);
    --left;
  }
  return left > 0 ? text + " and " + std::to_string(left) + " more" : text;
}

}  // namespace

std::size_t choose_take(const std::string& file, const std::vector<TakeName>& takes,
                        const std::optional<std::string>& wanted, Warnings& warnings) {
  if (takes.empty())
    throw InputError(file, 0, 0, "holds no animation, but may be put on a clip as its character");
  std::size_t chosen = 0;
  if (wanted) {
    const auto named =
        std::ranges::find_if(takes, [&](const TakeName& take) { return take.name == *wanted; });
    const double number = parse_number(*wanted).value_or(0);
    if (named != takes.end())
      chosen = static_cast<std::size_t>(named - takes.begin());
    else if (number >= 1 && number <= static_cast<double>(takes.size()) &&
             number == std::floor(number))
      chosen = static_cast<std::size_t>(number) - 1;
    else
      throw InputError(file, 0, 0,
                       "has no take " + shortened(*wanted) + ": there are " + listed(takes, {}));
    return chosen;
  }
  const auto moving = std::ranges::find_if(takes, [](const TakeName& take) { return take.moves; });
  if (moving != takes.end()) chosen = static_cast<std::size_t>(moving - takes.begin());
  if (takes.size() > 1)
    warnings.push_back({file, 0,
                        "take " + shortened(takes[chosen].name) + " is read; there are also " +
                            listed(takes, chosen)});
  return chosen;
}

Takes choices(const std::vector<TakeName>& takes, std::size_t chosen) {
  Takes result;
  for (std::size_t i = 0; i < takes.size(); ++i) {
    if (!takes[i].moves && i != chosen) continue;
    const auto here = takes.begin() + static_cast<std::ptrdiff_t>(i);
    const bool is_first = std::none_of(
        takes.begin(), here, [&](const TakeName& before) { return before.name == here->name; });
    if (i == chosen) result.read = result.keys.size();
    result.keys.push_back(is_first ? here->name : std::to_string(i + 1));
  }
  return result;
}

}  // namespace mocapress
