// SPDX-License-Identifier: MIT
// Writes the outer form of a binary FBX file, which fbx_records.h reads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/formats/fbx/fbx_records.h"

namespace mocapress {

/// A record to be written: the bytes of its values, and nested records.
struct FbxOutRecord {
  std::string name;
  std::string values{};
  std::uint64_t count = 0;
  bool is_list = false;               // true: a record of zeros ends even an empty list
  std::list<FbxOutRecord> records{};  // a list keeps references to its records valid

  FbxOutRecord& value(std::int32_t number);
  FbxOutRecord& value(std::int64_t number);
  FbxOutRecord& value(double number);
  FbxOutRecord& value(std::string_view text);
  FbxOutRecord& raw(std::string_view bytes);
  FbxOutRecord& array(const std::vector<std::int32_t>& numbers);
  FbxOutRecord& array(const std::vector<std::int64_t>& numbers);
  FbxOutRecord& array(const std::vector<float>& numbers);
  FbxOutRecord& array(const std::vector<double>& numbers);

  FbxOutRecord& record(std::string_view inner);
  /// Adds a record with one value.
  template <typename Value>
  void field(std::string_view inner, const Value& inner_value) {
    record(inner).value(inner_value);
  }
  /// Adds a property record "P": name, type, label, flags; the caller adds its values.
  FbxOutRecord& property(std::string_view inner, std::string_view type, std::string_view label,
                         std::string_view flags);

 private:
  FbxOutRecord& add(std::string_view bytes);
};

/// The full name in binary files: "Knee" of "Model" is "Knee\0\1Model".
std::string fbx_full_name(std::string_view name, std::string_view type);

/// The bytes of a file with these records. Throws WriteError if the version's sizes are too small
/// for them.
std::string fbx_file_bytes(int version, const std::list<FbxOutRecord>& records);

/// Changes to the records of a file.
struct FbxEdits {
  std::unordered_map<const FbxRecord*, FbxOutRecord> replaced;
  std::unordered_set<const FbxRecord*> dropped;
  std::unordered_map<const FbxRecord*, std::list<FbxOutRecord>> added;  // appended to a record
};

/// The file's bytes with these changes. Nothing else changes except offsets of records. The source
/// must be binary and little-endian. Throws WriteError.
std::string fbx_edited_bytes(const FbxRecords& source, const FbxEdits& edits);

}  // namespace mocapress
