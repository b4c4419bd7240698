// SPDX-License-Identifier: MIT
// Files whose keys have times of their own (FBX, glTF) state no rate that can be relied upon. This
// is the one place that turns key times, and the rate a file states, into a rate of frames:
//
// 1. Keys one frame apart: the file's rate, the nearest usual rate or, if neither fits, the mean
//    rate of the keys. Keys may lie a little off their frames (kNearFrame), since many programs
//    round times to milliseconds.
// 2. Keys with gaps between them: the file's rate if keys lie near its frames, or else a usual
//    rate. A rate above 120 Hz is taken only if no lower one fits and keys are that dense.
// 3. Keys that fit no rate: the file's rate, or 30 Hz, and a warning.
//
// So no frame is added only because a key lies a little off. Added frames would make a clip look
// larger, and its compression better, than it is.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace mocapress {

/// The times at which keys are sampled.
struct SampleTimes {
  double first_s = 0;
  double rate_hz = 30;
  int frames = 1;
  double near_s = 0;    // a key this near to a frame belongs to it
  std::string warning;  // empty: every frame is at a key

  double at(int frame) const { return first_s + frame / rate_hz; }
};

/// Merges times into one ascending list without repetitions. `times` must already be ascending and
/// without repetitions.
std::vector<double> merged_times(const std::vector<double>& times, std::vector<double> more);

/// Sample times from the first key to the last. `keys_s`: sorted, finite, not empty. `stated_hz`:
/// the rate stated by the file. `wanted_hz`: the user's rate, which overrides the keys. Throws
/// InputError if a clip cannot hold so many frames of `moving_nodes`.
SampleTimes sample_times(const std::string& file, const std::vector<double>& keys_s,
                         std::optional<double> stated_hz, std::optional<double> wanted_hz,
                         std::size_t moving_nodes);

}  // namespace mocapress
