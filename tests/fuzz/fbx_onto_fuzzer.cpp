// SPDX-License-Identifier: MIT
// Any bytes as a .fbx that takes its own motion back, each joint turned: it is refused, or what is
// written can be read.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_onto.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string written;
  try {
    mocapress::MotionFile file = mocapress::read_fbx("fuzz.fbx", bytes);
    mocapress::Motion& motion = file.motion;
    for (int c = 0; c < motion.skeleton.channel_count(); ++c)
      if (is_rotation(motion.skeleton.channel_kind(c))) motion.clip.channels.col(c).array() += 0.1;
    written = mocapress::fbx_bytes_onto("fuzz.fbx", bytes, motion, {}, file.tracks);
  } catch (const mocapress::Error&) {
    return 0;
  }
  mocapress::FbxFile again("again.fbx", written);
  mocapress::read_fbx_take(again, {});
  return 0;
}
