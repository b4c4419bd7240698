// SPDX-License-Identifier: MIT
#include "core/formats/fbx/fbx_reader.h"

#include "core/formats/fbx/fbx_scene.h"
#include "core/formats/node_motion.h"

namespace mocapress {

MotionFile read_fbx(const std::string& name, std::string_view bytes, const ReadOptions& options) {
  FbxFile file(name, bytes);
  FbxTake read = read_fbx_take(file, options);
  MotionFile motion = motion_of(name, read.take, options, SourceFormat::Kind::Fbx);
  motion.warnings.insert(motion.warnings.begin(), read.warnings.begin(), read.warnings.end());
  motion.takes = std::move(read.takes);
  return motion;
}

Character read_fbx_character(const std::string& name, std::string_view bytes) {
  FbxFile file(name, bytes);
  return character_of(name, read_fbx_rest(file).take);
}

}  // namespace mocapress
