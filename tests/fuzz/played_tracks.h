// SPDX-License-Identifier: MIT
// Plays the tracks of any clip, for fuzz targets.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/own_memory.h"
#include "tests/support/opened_clip.h"

namespace mocapress::test {

inline constexpr mcpr_wrap kWraps[] = {MCPR_CLAMP,     MCPR_LOOP,       MCPR_PING_PONG,
                                       MCPR_LOOP_JUMP, MCPR_LOOP_BLEND, MCPR_LOOP_HOLD};

/// Samples tracks before, in and after the clip, and lists what changed of them: each change once,
/// however time is cut, forwards and backwards.
inline void play_tracks(const mcpr_tracks* tracks, std::uint32_t frames) {
  constexpr std::uint32_t kMostListed = 4096;
  OpenedClip::frames_of(tracks, 0, std::min<std::uint32_t>(frames, 8));
  const double end = std::min(frames, kMostListed);
  for (const mcpr_wrap wrap : kWraps) {
    const mcpr_track_request request{.wrap = wrap};
    const AlignedBytes scratch(mcpr_track_scratch_bytes(tracks, &request));
    std::vector<float> values(mcpr_track_values(tracks, &request));
    const auto is_played = [&](double time) {
      return mcpr_track_moment(tracks, &request, time, values.data(), scratch.data(),
                               scratch.size(), nullptr) == MCPR_OK;
    };
    if (values.empty() || !is_played(0)) continue;  // no tracks, or no loop
    for (const double time : {0.25, frames - 1.0, frames + 0.5, -3.5, 1e9})
      if (!is_played(time)) std::abort();
    const auto changes = [&](double from, double to) {
      mcpr_change some[4];
      std::uint32_t count = 0;
      if (mcpr_track_changes(tracks, &request, from, to, some, 4, &count, nullptr) != MCPR_OK)
        std::abort();
      return count;
    };
    const std::uint32_t all = changes(-0.5 * end, 1.5 * end);
    if (changes(-0.5 * end, 0.3 * end) + changes(0.3 * end, 1.5 * end) != all) std::abort();
    if (changes(1.5 * end, -0.5 * end) != all) std::abort();
  }
}

}  // namespace mocapress::test
