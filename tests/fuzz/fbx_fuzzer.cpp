// SPDX-License-Identifier: MIT
// Any bytes as a .fbx: they are read or refused.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/fbx_reader.h"

// Assimp does not give back what it has read of a file that it then refuses.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libassimp\nleak:inflateInit";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    mocapress::read_fbx("fuzz.fbx", {reinterpret_cast<const char*>(data), size});
  } catch (const mocapress::Error&) {
  }
  return 0;
}
