// SPDX-License-Identifier: MIT
// Any bytes as a .fbx that takes its own motion back, each joint turned, or its pose at rest if it
// has no key: it is refused, or what is written can be read.
#include <string_view>

#include "core/base/error.h"
#include "core/formats/fbx/fbx_onto.h"
#include "core/formats/fbx/fbx_reader.h"
#include "core/formats/fbx/fbx_scene.h"

namespace {

mocapress::MotionFile motion_of_file(std::string_view bytes) {
  try {
    return mocapress::read_fbx("fuzz.fbx", bytes);
  } catch (const mocapress::Error&) {
    mocapress::FbxFile file("fuzz.fbx", bytes);
    mocapress::NodeTake rest = mocapress::read_fbx_rest(file).take;
    rest.tracks = {{.node = "n", .name = "p", .values = {1}}};  // so that it may stand still
    return mocapress::motion_of("fuzz.fbx", rest, {}, mocapress::SourceFormat::Kind::Fbx);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  std::string written;
  try {
    mocapress::MotionFile file = motion_of_file(bytes);
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
