// SPDX-License-Identifier: MIT
// The outer form of a binary FBX file on its way out (fbx_records.h reads it).
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

/// A record to be written: its values as their bytes, and the records in it.
struct FbxOutRecord {
  std::string name;
  std::string values{};
  std::uint64_t count = 0;
  bool is_list = false;               // it ends as a list does, though nothing is in it
  std::list<FbxOutRecord> records{};  // references to them stay

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
  /// A record of one value.
  template <typename Value>
  void field(std::string_view inner, const Value& inner_value) {
    record(inner).value(inner_value);
  }
  /// P: name, type, label, flags; its values follow.
  FbxOutRecord& property(std::string_view inner, std::string_view type, std::string_view label,
                         std::string_view flags);

 private:
  FbxOutRecord& add(std::string_view bytes);
};

/// "Knee", "Model": "Knee\0\1Model".
std::string fbx_full_name(std::string_view name, std::string_view type);

/// The bytes of a file of these records. Throws WriteError where the version cannot hold so much.
std::string fbx_file_bytes(int version, const std::list<FbxOutRecord>& records);

/// Changes to the records of a file.
struct FbxEdits {
  std::unordered_map<const FbxRecord*, FbxOutRecord> replaced;
  std::unordered_set<const FbxRecord*> dropped;
  std::unordered_map<const FbxRecord*, std::list<FbxOutRecord>> added;  // at the end of a record
};

/// The file once more with these changes; all other bytes are as they were, but for the places that
/// records state. It must be binary and little-endian. Throws WriteError.
std::string fbx_edited_bytes(const FbxRecords& source, const FbxEdits& edits);

}  // namespace mocapress
