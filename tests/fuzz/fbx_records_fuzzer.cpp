// SPDX-License-Identifier: MIT
// Reads all values of all records in any bytes as a .fbx, or sees them refused.
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_records.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    mocapress::FbxRecords records("fuzz.fbx", {reinterpret_cast<const char*>(data), size});
    std::vector<const mocapress::FbxRecord*> open = {&records.top()};
    while (!open.empty()) {
      const mocapress::FbxRecord* const record = open.back();
      open.pop_back();
      for (const auto* child = records.first_child(*record); child != nullptr;
           child = records.next(*child))
        open.push_back(child);
      try {
        records.numbers(*record);
        records.integers(*record);
        records.float_bits(*record);
      } catch (const mocapress::Error&) {
      }
    }
  } catch (const mocapress::Error&) {
  }
  return 0;
}
