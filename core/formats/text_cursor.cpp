// SPDX-License-Identifier: MIT
#include "core/formats/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::size_t index(char c) {
  return static_cast<unsigned char>(c);
}

/// True if a text is UTF-16: it has the byte order mark, or every other byte of plain words is
/// zero.
bool is_utf16(std::string_view text) {
  return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
         (text.size() > 3 && (text[0] == '\0') != (text[1] == '\0') &&
          (text[0] == '\0') == (text[2] == '\0') && (text[1] == '\0') == (text[3] == '\0'));
}

/// True if a word is a number such as "0,5".
bool has_decimal_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == text.npos || comma + 1 == text.size()) return false;
  std::string with_point(text);
  with_point[comma] = '.';
  return parse_number(with_point).has_value();
}

/// True if digits are "1.#QNAN", "-1.#IND00", "1.#INF" or the like, as older Microsoft libraries
/// print numbers that are not finite.
bool is_microsoft_nan(std::string_view digits) {
  return digits.starts_with("1.#");
}

}  // namespace

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<double> parse_number(std::string_view text) {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (end == text.data() + text.size()) {
    if (error == std::errc()) return value;
    if (error == std::errc::result_out_of_range)
      return text.find_first_of("eE") != text.npos && text.find('-', 1) != text.npos ? 0.0
                                                                                     : kNotANumber;
  }
  if (text.starts_with('-')) text.remove_prefix(1);
  return is_microsoft_nan(text) ? std::optional(kNotANumber) : std::nullopt;
}

TextCursor::TextCursor(std::string file, std::string_view text, std::string_view punctuation,
                       char comment)
    : file_(std::move(file)), text_(text), comment_(comment) {
  for (const char c : {' ', '\t', '\r', '\n', '\v', '\f'}) is_space_[index(c)] = true;
  for (const char c : punctuation) is_punctuation_[index(c)] = true;
  if (text_.starts_with(kByteOrderMark)) text_.remove_prefix(kByteOrderMark.size());
  if (is_utf16(text_)) fail({}, "is UTF-16: save it as UTF-8 to have it read");
  while (text_.ends_with('\x1A') || text_.ends_with('\0')) text_.remove_suffix(1);
  scan();
}

Token TextCursor::take() {
  const Token taken = token_;
  scan();
  return taken;
}

bool TextCursor::skip(std::string_view word) {
  if (!next_is(word)) return false;
  scan();
  return true;
}

void TextCursor::expect(std::string_view word) {
  if (!skip(word)) fail_expecting(word);
}

Token TextCursor::take_line(char stop) {
  Token line = token_;
  const auto begin = static_cast<std::size_t>(token_.text.data() - text_.data());
  auto end = begin;
  const auto begins_comment = [&](std::size_t at) {
    return comment_ != '\0' && text_[at] == comment_ && is_space_[index(text_[at - 1])];
  };
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r' && text_[end] != stop &&
         (end == begin || !begins_comment(end)))
    ++end;
  position_ = end;
  while (end > begin && is_space_[index(text_[end - 1])]) --end;
  line.text = text_.substr(begin, end - begin);
  scan();
  return line;
}

void TextCursor::skip_line(int line) {
  if (on_line(line)) take_line();
}

double TextCursor::take_number(std::string_view what) {
  const auto value = parse_number(token_.text);
  if (!value) fail_expecting_number(token_, what);
  scan();
  return *value;
}

double TextCursor::take_measure(std::string_view what) {
  const Token at = token_;
  const double value = take_number(what);
  constexpr double kLargest = 1e9;
  if (!(std::abs(value) <= kLargest))
    fail(at, "expected " + std::string(what) + ", found " + quoted(at));
  return value;
}

void TextCursor::treat_as_space(char character) {
  is_space_[index(character)] = true;
}

void TextCursor::fail(const Token& at, const std::string& message) const {
  throw InputError(file_, at.line, at.column, message);
}

void TextCursor::fail_expecting(std::string_view what) const {
  fail(token_, "expected " + std::string(what) + ", found " + quoted(token_));
}

void TextCursor::fail_expecting_number(const Token& at, std::string_view what) const {
  if (has_decimal_comma(at.text))
    fail(at, "numbers have a decimal comma, such as " + quoted(at) + ": a decimal point is read");
  fail(at, "expected " + std::string(what) + ", found " + quoted(at));
}

void TextCursor::begin_line(std::size_t start) {
  ++line_;
  line_start_ = start;
}

void TextCursor::skip_space() {
  for (; position_ < text_.size(); ++position_) {
    const char c = text_[position_];
    if (c == comment_ && comment_ != '\0') {
      position_ = std::min(text_.find_first_of("\r\n", position_), text_.size()) - 1;
      continue;
    }
    if (!is_space_[index(c)]) return;
    const bool lone_return =
        c == '\r' && (position_ + 1 == text_.size() || text_[position_ + 1] != '\n');
    if (c == '\n' || lone_return) begin_line(position_ + 1);
  }
}

void TextCursor::scan() {
  skip_space();
  const std::size_t begin = position_;
  if (begin < text_.size() && is_punctuation_[index(text_[begin])]) {
    ++position_;
  } else {
    while (position_ < text_.size() && !is_space_[index(text_[position_])] &&
           !is_punctuation_[index(text_[position_])])
      ++position_;
  }
  token_ = {text_.substr(begin, position_ - begin), line_,
            static_cast<int>(begin - line_start_) + 1};
}

std::string quoted(const Token& token) {
  constexpr std::size_t kLongest = 40;
  if (token.text.empty()) return "the end of the file";
  std::string text(token.text.substr(0, kLongest));
  std::ranges::replace_if(
      text, [](char c) { return index(c) < 0x20 || index(c) > 0x7E; }, '?');
  return "'" + text + (token.text.size() > kLongest ? "...'" : "'");
}

}  // namespace mocapress
