// SPDX-License-Identifier: MIT
#include "core/report/clip_link.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/base/printable.h"
#include "core/base/utf8_path.h"
#include "core/formats/clip_files.h"
#include "core/formats/text_cursor.h"

namespace mocapress {
namespace {

constexpr std::string_view kStart = "mocapress://open?";

/// Percent-encodes all characters but letters, digits and a few marks, so that the result can stand
/// in mails and HTML unchanged.
std::string encoded(std::string_view text) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  constexpr std::string_view kPlain = "-_.~/:,";
  std::string all;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_plain = byte < 0x80 && (std::isalnum(byte) || kPlain.find(c) != kPlain.npos);
    if (is_plain)
      all += c;
    else
      all.append("%").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
  }
  return all;
}

/// The value of a hexadecimal digit; -1 for any other character.
int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string decoded(std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
    if (low >= 0) i += 2;
    all += low >= 0 ? static_cast<char>(16 * high + low) : text[i];
  }
  return all;
}

/// True for the absolute path of a motion or .mcpr on this computer. Excludes shares, devices and
/// paths with "..".
bool is_harmless(const std::string& path) {
  const bool is_drive = path.size() > 2 && std::isalpha(static_cast<unsigned char>(path[0])) &&
                        path[1] == ':' && (path[2] == '/' || path[2] == '\\');
  const bool is_share = path.size() > 1 && (path[1] == '/' || path[1] == '\\');
  if (!is_drive && (path.empty() || path[0] != '/' || is_share)) return false;
  if (printable(path) != path) return false;
  for (const auto* folder : {"/dev/", "/proc/", "/sys/"})
    if (path.starts_with(folder)) return false;
  const std::filesystem::path file = utf8_path(path);
  if (std::ranges::find(file, "..") != file.end() || path.find("\\..") != path.npos) return false;
  return is_clip(file) || equals_ignoring_case(utf8(file.extension()), ".mcpr");
}

/// Returns the text before the next mark, and removes it and the mark from `rest`.
std::string_view take_until(std::string_view& rest, char mark) {
  const std::size_t end = rest.find(mark);
  const std::string_view before = rest.substr(0, end);
  rest = end == rest.npos ? std::string_view() : rest.substr(end + 1);
  return before;
}

std::optional<std::array<double, 6>> camera_in(std::string_view text) {
  std::array<double, 6> camera{};
  for (double& value : camera) {
    const std::optional<double> number = number_in(take_until(text, ','));
    if (!number || std::abs(*number) > 1e9) return std::nullopt;
    value = *number;
  }
  return text.empty() ? std::optional(camera) : std::nullopt;
}

}  // namespace

std::string link_text(const ClipLink& link) {
  std::string text(kStart);
  text += "clip=" + encoded(link.clip);
  if (link.take) text += "&take=" + encoded(*link.take);
  if (link.frame) text += "&frame=" + std::to_string(*link.frame);
  if (!link.joint.empty()) text += "&joint=" + encoded(link.joint);
  if (!link.camera) return text;
  const char* before = "&camera=";
  for (const double number : *link.camera) {
    text += before + fixed_text(number, 1);
    before = ",";
  }
  return text;
}

ClipLink parse_clip_link(std::string_view text) {
  ClipLink link;
  std::string_view rest = text;
  const std::string_view place = take_until(rest, '?');
  // A browser may have added a slash: mocapress://open/?clip=...
  if (place != "mocapress://open" && place != "mocapress://open/") rest = {};
  while (!rest.empty()) {
    std::string_view field = take_until(rest, '&');
    const std::string_view key = take_until(field, '=');
    const std::string value = decoded(field);
    if (key == "clip") link.clip = value;
    if (key == "take") link.take = value;
    if (key == "joint") link.joint = value;
    if (key == "camera") link.camera = camera_in(value);
    if (key == "frame")
      if (const auto frame = number_in(value); frame && *frame >= 0 && *frame < 1e9)
        link.frame = static_cast<int>(*frame);
  }
  if (!is_harmless(link.clip))
    throw Error("the link is refused, for it names no clip by an absolute path on this computer: " +
                printable(text.substr(0, 200)));
  return link;
}

}  // namespace mocapress
