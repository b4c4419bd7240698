// SPDX-License-Identifier: MIT
// Reads any text as a .bvh. A text is refused, or its motion can be written and read again.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/bvh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  std::string again;
  try {
    const mocapress::MotionFile file = mocapress::read_bvh("fuzz.bvh", text);
    again = mocapress::bvh_text(file.motion, mocapress::bvh_style(file.source));
  } catch (const mocapress::Error&) {
    return 0;
  }
  mocapress::read_bvh("again.bvh", again);
  return 0;
}
