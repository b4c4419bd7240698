// SPDX-License-Identifier: MIT
// The outer form of an FBX file: records with values and nested records. Binary files (32 and 64
// bits, either byte order) and ASCII files give the same tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mocapress {

/// From this version on, records have 64-bit ends and counts.
inline constexpr int kFbxWideVersion = 7500;

struct FbxValue {
  enum class Kind { Integer, Real, Text, Array };
  Kind kind = Kind::Integer;
  std::int64_t integer = 0;
  double real = 0;
  std::string_view text;  // for an array: its bytes in the file, from the element type on

  double number() const;       // NaN for a text
  std::int64_t whole() const;  // a real number is rounded; 0 if the value is no number
  char letter() const;         // a single letter of version 6; 0: none
};

struct FbxRecord {
  std::string_view name;
  std::string_view values;        // as in the file
  std::size_t value_count = 0;    // in a binary file
  std::size_t at = 0;             // its start: a byte of a binary file, a line of an ASCII one
  std::uint32_t first_child = 0;  // 0: none
  std::uint32_t next = 0;         // next record of the same parent; 0: none
};

/// A parsed FBX file. All functions throw InputError for invalid content. The bytes must outlive
/// it.
class FbxRecords {
 public:
  FbxRecords(const std::string& file, std::string_view bytes);

  const std::string& file() const { return file_; }
  std::string_view bytes() const { return bytes_; }
  bool is_binary() const { return is_binary_; }
  bool is_big_endian() const { return is_big_endian_; }
  int version() const { return version_; }  // Version 7.4 is 7400.

  /// The root, whose nested records are those of the file's top level.
  const FbxRecord& top() const { return records_.front(); }
  const FbxRecord* first_child(const FbxRecord& record) const;
  const FbxRecord* next(const FbxRecord& record) const;
  /// The first record of that name in `in`; null: none.
  const FbxRecord* find(const FbxRecord& in, std::string_view name) const;

  std::vector<FbxValue> values(const FbxRecord& record) const;
  std::optional<FbxValue> value(const FbxRecord& record, std::size_t index) const;
  /// The text in the first value of the named record; empty: none.
  std::string text(const FbxRecord& in, std::string_view name) const;

  /// All numbers of a record: one array, or values in a row.
  std::vector<double> numbers(const FbxRecord& record);
  std::vector<std::int64_t> integers(const FbxRecord& record);
  /// The bits of 32-bit floats, some of which hold packed integers.
  std::vector<std::uint32_t> float_bits(const FbxRecord& record);
  /// Numbers of the named record; none if it is missing.
  std::vector<double> numbers(const FbxRecord& in, std::string_view name);
  std::vector<std::int64_t> integers(const FbxRecord& in, std::string_view name);

  /// Throws InputError "file: message (byte 123)", or with a line.
  [[noreturn]] void fail(const FbxRecord& at, const std::string& message) const;
  [[noreturn]] void fail(const std::string& message) const;

 private:
  class BinaryScan;
  class AsciiScan;

  [[noreturn]] void fail_at(std::size_t at, const std::string& message) const;
  std::uint32_t add(const FbxRecord& record);
  template <typename Number>
  Number number_at(std::string_view bytes, std::size_t at) const;
  template <typename Number, typename Convert>
  std::vector<Number> collected(const FbxRecord& record, const Convert& convert);
  std::string unpacked(const FbxRecord& record, std::string_view array, std::size_t& count);

  std::string file_;
  std::string_view bytes_;
  bool is_binary_ = false;
  bool is_big_endian_ = false;
  int version_ = 0;
  std::vector<FbxRecord> records_;
  std::size_t unpacked_bytes_ = 0;
};

/// A full name, "Knee\0\1Model" in binary and "Model::Knee" in ASCII files, split into Knee and
/// Model.
struct FbxName {
  std::string name;
  std::string type;
};
FbxName fbx_name(std::string_view text);

}  // namespace mocapress
