// SPDX-License-Identifier: MIT
#include "resources/samples/generator/samples.h"

#include "core/formats/motion_file.h"

namespace mocapress::samples {

Motion walk_clip() {
  return perform(walk(), 11);
}
Motion run_clip() {
  return perform(run(), 12);
}
Motion jump_clip() {
  return perform(jump(), 13);
}

void write_samples(const std::filesystem::path& folder) {
  const std::filesystem::path skeleton = folder / "human.asf";
  write_motion(folder / "human_walk.amc", walk_clip(), skeleton);
  write_motion(folder / "human_run.amc", run_clip(), skeleton);
  write_motion(folder / "human_jump.amc", jump_clip(), skeleton);
}

}  // namespace mocapress::samples
