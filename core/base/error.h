// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace mocapress {

/// A failure that input, files or the system can cause. Bugs are asserts, never an Error.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An input file that cannot be read. what() is "file:line:column: message"; line and column count
/// from 1, and line 0 stands for the file as a whole ("file: message"). The message becomes one
/// printable() line of at most 200 characters, however long the names in it are.
class InputError : public Error {
 public:
  InputError(const std::string& file, int line, int column, const std::string& message);
  int line() const { return line_; }
  int column() const { return column_; }

 private:
  int line_;
  int column_;
};

/// Bytes that are not a valid compressed clip. what() names the offset of the first offending byte.
class FormatError : public Error {
 public:
  FormatError(std::size_t byte_offset, const std::string& message);
  std::size_t byte_offset() const { return byte_offset_; }

 private:
  std::size_t byte_offset_;
};

/// A file that cannot be written.
class WriteError : public Error {
  using Error::Error;
};

/// A quality target (ratio, size, error) that no setting of the method meets. what() tells the best
/// result.
class TargetMissed : public Error {
  using Error::Error;
};

/// A repair or guess by a reader: worth telling, but no reason to refuse the file.
struct Warning {
  std::string file;
  int line = 0;  // from 1; 0: the file as a whole
  std::string message;

  std::string text() const;  // in the form of InputError::what()
  bool operator==(const Warning&) const = default;
};

using Warnings = std::vector<Warning>;

}  // namespace mocapress
