// SPDX-License-Identifier: MIT
// Reads any bytes as a .glb or .gltf. They are refused, or their motion can be written.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/gltf_reader.h"
#include "core/formats/gltf_writer.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const mocapress::MotionFile file = mocapress::read_gltf("fuzz.glb", bytes);
    if (file.motion.clip.frames() > 10'000) return 0;
    using enum mocapress::GltfContainer;
    mocapress::read_gltf("again.glb", mocapress::gltf_bytes(file.motion, Glb, file.source));
  } catch (const mocapress::Error&) {
    return 0;
  }
  return 0;
}
