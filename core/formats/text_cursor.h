// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// A word of a text file and where it stands, both counted from 1. Empty at the end of the file.
struct Token {
  std::string_view text;
  int line = 1;
  int column = 1;
};

/// ASCII letters only: the keywords of motion files.
bool equals_ignoring_case(std::string_view a, std::string_view b);

/// The number that `text` is, whatever the locale; none when it is something else. "nan", "inf",
/// "1.#QNAN" and numbers too large for a double are numbers, but not finite.
std::optional<double> parse_number(std::string_view text);

/// Walks a text word by word, one word ahead. Every failure is an InputError that says where. The
/// text must outlive the cursor and its tokens.
class TextCursor {
 public:
  /// Characters of `punctuation` are words of their own; a word that begins with `comment` hides
  /// the rest of its line. What may pad the end of a text, zeros and the end sign of CP/M (0x1A),
  /// is no part of it. Throws InputError where the text is UTF-16.
  TextCursor(std::string file, std::string_view text, std::string_view punctuation, char comment);

  const std::string& file() const { return file_; }
  const Token& peek() const { return token_; }
  bool at_end() const { return token_.text.empty(); }
  bool next_is(std::string_view word) const { return equals_ignoring_case(token_.text, word); }
  bool on_line(int line) const { return !at_end() && token_.line == line; }

  Token take();

  /// Takes the next word if it is this one.
  bool skip(std::string_view word);
  void expect(std::string_view word);

  /// The next word and all that follows it on its line, up to `stop` or a comment.
  Token take_line(char stop = '\n');
  void skip_line(int line);

  /// `what` completes the sentence "expected ..., found ...". A measure is finite, at most 1e9.
  double take_number(std::string_view what);
  double take_measure(std::string_view what);

  /// Fails at a word that should be a number. One with a decimal comma is named as such.
  [[noreturn]] void fail_expecting_number(const Token& at, std::string_view what) const;

  /// From the word after the next, `character` separates words as a space does.
  void treat_as_space(char character);

  [[noreturn]] void fail(const Token& at, const std::string& message) const;
  [[noreturn]] void fail_expecting(std::string_view what) const;

 private:
  void scan();
  void skip_space();
  void begin_line(std::size_t start);

  std::string file_;
  std::string_view text_;
  char comment_;
  std::array<bool, 256> is_space_{};
  std::array<bool, 256> is_punctuation_{};
  std::size_t position_ = 0;    // just after token_
  std::size_t line_start_ = 0;  // where the line of position_ begins
  int line_ = 1;
  Token token_;
};

/// What stands there, for a message: the word in quotes, shortened, or "the end of the file".
std::string quoted(const Token& token);

}  // namespace mocapress
