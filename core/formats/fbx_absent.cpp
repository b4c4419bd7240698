// SPDX-License-Identifier: MIT
#include "core/base/error.h"
#include "core/formats/fbx_reader.h"

namespace mocapress {

MotionFile read_fbx(const std::string& file, std::string_view, const ReadOptions&) {
  throw InputError(file, 0, 0, "cannot be read: this build of Mocapress has no FBX");
}

Character read_fbx_character(const std::string& file, std::string_view bytes) {
  read_fbx(file, bytes);
  return {};
}

}  // namespace mocapress
