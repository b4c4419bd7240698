// SPDX-License-Identifier: MIT
// Clips for studies: named files or folders, in full or thinned.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// The file itself, or a folder's .amc and .bvh files, sorted.
inline std::vector<std::filesystem::path> clips_of(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> clips;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.path().extension() == ".amc" || entry.path().extension() == ".bvh")
      clips.push_back(entry.path());
  std::sort(clips.begin(), clips.end());
  return clips;
}

/// Every `every`-th frame, starting with the first.
inline Motion thinned(Motion motion, int every) {
  const auto frames = Eigen::seq(0, motion.clip.frames() - 1, every);
  motion.clip.channels = motion.clip.channels(frames, Eigen::all).eval();
  motion.clip.sample_rate_hz /= every;
  return motion;
}

}  // namespace mocapress
