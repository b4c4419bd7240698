// SPDX-License-Identifier: MIT
// Samples for fitting the adaptive coding. They come from other clips than those of the
// measurements, on their own and on game-like rigs, at several rates and errors.
#pragma once

#include <cstdio>
#include <filesystem>

#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/format/adaptive.h"
#include "core/formats/motion_file.h"
#include "tests/bench/study_clips.h"
#include "tests/support/game_like.h"

namespace mocapress {

/// Calls visit(signals, neighbours) with each sample of the clips of a folder.
template <typename Visit>
void for_each_sample(const std::filesystem::path& folder, const Visit& visit) {
  constexpr int kEvery[] = {1, 2, 4};                           // frames: 120, 60 and 30 Hz
  constexpr double kScales[] = {4, 2.4, 1.2, 0.5, 0.15, 0.04};  // cm; eps_x is about half of it
  for (const std::filesystem::path& path : clips_of(folder)) {
    const Motion motion = read_motion(path).motion;
    for (const Motion& rig : {motion, test::game_like(motion)})
      for (const int every : kEvery) {
        const ClipAnalysis source(thinned(rig, every));
        const ClipAnalysis& analysis = source.in_chosen_forms();
        const ClosedLoop& loop = analysis.closed_loop(Basis::Cubic, Weighting::Surface);
        const auto neighbours = channel_neighbours(analysis.motion().skeleton);
        for (const double scale : kScales) visit(loop.quantise(scale).coded, neighbours);
      }
    std::fprintf(stderr, "%s\n", path.stem().c_str());
  }
}

}  // namespace mocapress
