// SPDX-License-Identifier: MIT
// What studies run over: clips named or in folders, as they are or thinned.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// A file itself; of a folder its .amc and .bvh files, sorted.
inline std::vector<std::filesystem::path> clips_of(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> clips;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.path().extension() == ".amc" || entry.path().extension() == ".bvh")
      clips.push_back(entry.path());
  std::sort(clips.begin(), clips.end());
  return clips;
}

/// Every so many-th frame, the first of all among them.
inline Motion thinned(Motion motion, int every) {
  const auto frames = Eigen::seq(0, motion.clip.frames() - 1, every);
  motion.clip.channels = motion.clip.channels(frames, Eigen::all).eval();
  motion.clip.sample_rate_hz /= every;
  return motion;
}

}  // namespace mocapress
