// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace mocapress {

/// A word of a text file with its line and column, counted from 1. Empty at the end of the file.
struct Token {
  std::string_view text;
  int line = 1;
  int column = 1;
};

/// Compares words, ignoring the case of ASCII letters, as for the keywords of motion files.
bool equals_ignoring_case(std::string_view a, std::string_view b);

/// The number written in `text`, in any locale; unset if `text` is no number. "nan", "inf",
/// "1.#QNAN" and numbers too large for a double are numbers, but not finite.
std::optional<double> parse_number(std::string_view text);

/// Walks a text word by word, one word ahead. Every failure is an InputError with its place. The
/// text must outlive the cursor and its tokens.
class TextCursor {
 public:
  /// Each character of `punctuation` is a word of its own. A word that begins with `comment` hides
  /// the rest of its line. Padding at the end of a text, zeros and CP/M's end sign (0x1A), is
  /// ignored. Throws InputError for UTF-16.
  TextCursor(std::string file, std::string_view text, std::string_view punctuation, char comment);

  const std::string& file() const { return file_; }
  const Token& peek() const { return token_; }
  bool at_end() const { return token_.text.empty(); }
  bool next_is(std::string_view word) const { return equals_ignoring_case(token_.text, word); }
  bool on_line(int line) const { return !at_end() && token_.line == line; }

  Token take();

  /// Takes the next word if it equals `word`.
  bool skip(std::string_view word);
  void expect(std::string_view word);

  /// The next word and everything after it on its line, up to `stop` or a comment.
  Token take_line(char stop = '\n');
  void skip_line(int line);

  /// `what` completes the sentence "expected ..., found ...". A measure must be finite and at most
  /// 1e9.
  double take_number(std::string_view what);
  double take_measure(std::string_view what);

  /// Fails at a word that should be a number. The message points out a decimal comma.
  [[noreturn]] void fail_expecting_number(const Token& at, std::string_view what) const;

  /// Makes `character` separate words like a space, from the word after the next.
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
  std::size_t line_start_ = 0;  // start of position_'s line
  int line_ = 1;
  Token token_;
};

/// A token for a message: the word in quotes, shortened, or "the end of the file".
std::string quoted(const Token& token);

}  // namespace mocapress
