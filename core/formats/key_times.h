// SPDX-License-Identifier: MIT
// Files whose keys have times of their own (FBX, glTF) state no rate that can be relied upon. This
// finds the rate at which the keys were made, so that as many frames as possible are keys.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mocapress {

/// The instants at which keys are sampled.
struct SampleTimes {
  double first_s = 0;
  double rate_hz = 30;
  int frames = 1;
  std::string warning;  // empty: every frame is a key

  double at(int frame) const { return first_s + frame / rate_hz; }
};

/// Sorted times without repetition: those of `times`, which are so already, and of `more`.
std::vector<double> merged_times(const std::vector<double>& times, std::vector<double> more);

/// From the first key to the last. `keys_s`: sorted, finite, not empty. `stated_hz`: what the file
/// says beside its keys. `wanted_hz`: what the user asks for, whatever the keys say. Throws
/// InputError where a clip cannot hold so many frames of `moving_nodes`.
SampleTimes sample_times(const std::string& file, const std::vector<double>& keys_s,
                         std::optional<double> stated_hz, std::optional<double> wanted_hz,
                         std::size_t moving_nodes);

}  // namespace mocapress
