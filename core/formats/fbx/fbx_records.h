// SPDX-License-Identifier: MIT
// The outer form of an FBX file: records with values, that hold records. Binary files (32 and 64
// bits, either byte order) and ASCII ones become the same tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mocapress {

/// From this version on, records state their ends and counts in 64 bits.
inline constexpr int kFbxWideVersion = 7500;

struct FbxValue {
  enum class Kind { Integer, Real, Text, Array };
  Kind kind = Kind::Integer;
  std::int64_t integer = 0;
  double real = 0;
  std::string_view text;  // of an array: its bytes in the file, from its type on

  double number() const;       // a text: NaN
  std::int64_t whole() const;  // a real is rounded; what is no number: 0
  char letter() const;         // of the single letters of version 6; 0: none
};

struct FbxRecord {
  std::string_view name;
  std::string_view values;      // as they stand in the file
  std::size_t value_count = 0;  // of a binary file
  std::size_t at = 0;           // where it begins: a byte of a binary file, a line of an ASCII one
  std::uint32_t first_child = 0;  // 0: none
  std::uint32_t next = 0;         // of its parent's; 0: none
};

/// A file taken apart. What cannot be read is an InputError, from all of these. The bytes must
/// outlive it.
class FbxRecords {
 public:
  FbxRecords(const std::string& file, std::string_view bytes);

  const std::string& file() const { return file_; }
  std::string_view bytes() const { return bytes_; }
  bool is_binary() const { return is_binary_; }
  bool is_big_endian() const { return is_big_endian_; }
  int version() const { return version_; }  // 7400 is 7.4

  /// Holds the records that no other holds.
  const FbxRecord& top() const { return records_.front(); }
  const FbxRecord* first_child(const FbxRecord& record) const;
  const FbxRecord* next(const FbxRecord& record) const;
  /// The first of that name in a record; null: none.
  const FbxRecord* find(const FbxRecord& in, std::string_view name) const;

  std::vector<FbxValue> values(const FbxRecord& record) const;
  std::optional<FbxValue> value(const FbxRecord& record, std::size_t index) const;
  /// The text of the first value of the record of that name; empty: there is none.
  std::string text(const FbxRecord& in, std::string_view name) const;

  /// All numbers of a record: one array, or values in a row.
  std::vector<double> numbers(const FbxRecord& record);
  std::vector<std::int64_t> integers(const FbxRecord& record);
  /// The bits of 32-bit floats, some of which hold packed integers.
  std::vector<std::uint32_t> float_bits(const FbxRecord& record);
  /// Numbers of the record of that name in another; none where it is not there.
  std::vector<double> numbers(const FbxRecord& in, std::string_view name);
  std::vector<std::int64_t> integers(const FbxRecord& in, std::string_view name);

  /// "file: message (byte 123)", or with its line.
  [[noreturn]] void fail(const FbxRecord& at, const std::string& message) const;
  [[noreturn]] void fail(const std::string& message) const;

 private:
  class BinaryScan;
  class AsciiScan;

  [[noreturn]] void fail_at(std::size_t at, const std::string& message) const;
  std::uint32_t add(const FbxRecord& record);
  template <typename Number>
  Number number_at(std::string_view bytes, std::size_t at) const;
  template <typename Take>
  void for_each_number(const FbxRecord& record, const Take& take);
  std::string unpacked(const FbxRecord& record, std::string_view array, std::size_t& count);

  std::string file_;
  std::string_view bytes_;
  bool is_binary_ = false;
  bool is_big_endian_ = false;
  int version_ = 0;
  std::vector<FbxRecord> records_;
  std::size_t unpacked_bytes_ = 0;
};

/// "Knee\0\1Model" of binary files and "Model::Knee" of ASCII ones: Knee, Model.
struct FbxName {
  std::string name;
  std::string type;
};
FbxName fbx_name(std::string_view text);

}  // namespace mocapress
