// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/file.h"
#include "core/formats/motion_file.h"
#include "resources/samples/generator/samples.h"

namespace mocapress::test {

/// Writes clips of different lengths, the starts of the bundled samples, as clip_100.bvh and so on.
inline void write_sample_clips(const std::filesystem::path& folder, int count) {
  std::filesystem::create_directories(folder);
  const std::vector<Motion> samples = {samples::walk_clip(), samples::run_clip(),
                                       samples::jump_clip()};
  for (int i = 0; i < count; ++i) {
    Motion motion = samples[static_cast<std::size_t>(i) % samples.size()];
    const int frames = std::min(motion.clip.frames(), 90 + 12 * i);
    motion.clip.channels = motion.clip.channels.topRows(frames).eval();
    write_motion(folder / ("clip_" + std::to_string(100 + i) + ".bvh"), motion);
  }
}

/// Everything that a batch wrote, by name, without journals, which contain times, and logs.
inline std::map<std::string, std::string> batch_contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::filesystem::path extension = entry.path().extension();
    if (entry.is_regular_file() && extension != ".jsonl" && extension != ".log")
      files[entry.path().lexically_relative(folder)] = read_text(entry.path());
  }
  return files;
}

}  // namespace mocapress::test
