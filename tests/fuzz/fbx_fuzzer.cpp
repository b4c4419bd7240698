// SPDX-License-Identifier: MIT
// Reads any bytes as a .fbx, or sees them refused.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    mocapress::read_fbx("fuzz.fbx", bytes);
  } catch (const mocapress::Error&) {
  }
  try {
    mocapress::read_fbx_character("fuzz.fbx", bytes);
  } catch (const mocapress::Error&) {
  }
  return 0;
}
