// SPDX-License-Identifier: MIT
// Reads any text as an .asf and, after a zero byte, as its .amc. A text is refused, or its motion
// can be written and read again.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/amc.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mocapress;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find('\0'), size);
  const std::string_view motion = text.substr(std::min(end + 1, size));
  std::string skeleton_again;
  std::string motion_again;
  try {
    const AsfSkeleton skeleton = read_asf("fuzz.asf", text.substr(0, end));
    const Motion written = acclaim_motion(read_amc("fuzz.amc", motion, skeleton).motion);
    skeleton_again = asf_text(written.skeleton);
    motion_again = amc_text(written);
  } catch (const Error&) {
    return 0;
  }
  read_amc("again.amc", motion_again, read_asf("again.asf", skeleton_again));
  return 0;
}
