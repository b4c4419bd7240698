// SPDX-License-Identifier: MIT
// Converts an instant of a player's time to a place in the clip.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/runtime/format/kinds.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// An instant within this many frames of a frame counts as that frame. Converting seconds to frames
/// rounds; and a frame is faster to compute than an instant between two, above all when playing at
/// half the rate.
inline constexpr float kAtFrame = 0x1p-16F;

/// A position in the clip; or on the way from its last frame to its first: then `across` is the
/// position between the two, 0 ... 1.
struct PlaceInClip {
  double frame = 0;
  float across = 0;
};

/// Number of frames in one cycle of a loop; 0: the clip is not a loop.
constexpr int turn_frames_of(int frames, LoopKind loop) {
  return loop == LoopKind::None ? 0 : frames - (loop == LoopKind::Repeats ? 1 : 0);
}

/// The caller's rule for instants before the first frame or after the last.
struct Wrapping {
  int frames = 1;
  LoopKind loop = LoopKind::None;
  mcpr_wrap wrap = MCPR_CLAMP;

  bool is_possible() const {
    return wrap >= MCPR_CLAMP && wrap <= MCPR_LOOP_HOLD &&
           (wrap != MCPR_LOOP || turn_frames_of(frames, loop) > 0);
  }

  /// Number of frames in one cycle; 0: the clip is not repeated.
  int cycle() const {
    switch (wrap) {
      case MCPR_CLAMP:
        break;
      case MCPR_LOOP:
        return turn_frames_of(frames, loop);
      case MCPR_PING_PONG:
        return 2 * (frames - 1);
      case MCPR_LOOP_JUMP:
        return frames - 1;
      case MCPR_LOOP_BLEND:
      case MCPR_LOOP_HOLD:
        return frames;
    }
    return 0;
  }

  PlaceInClip place(double frame) const {
    const double last = frames - 1.0;
    const int turn = cycle();
    if (turn == 0) return {std::clamp(frame, 0.0, last), 0};
    double within = frame;
    if (!(within >= 0 && within < turn)) {
      within = std::fmod(frame, turn);
      if (within < 0) within += turn;
      if (within >= turn) within = 0;  // a tiny negative instant is rounded up to a whole cycle
    }
    if (within <= last) return {within, 0};
    if (wrap == MCPR_PING_PONG) return {2 * last - within, 0};
    if (wrap == MCPR_LOOP_HOLD) return {last, 0};
    return {last, static_cast<float>(within - (turn - 1))};
  }
};

}  // namespace mocapress::runtime
