// SPDX-License-Identifier: MIT
// A cache of consecutive frames, for playing a clip. The frames are computed by the inverse
// transform. A frame gets the same bits whatever was asked for before.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

struct mcpr_cursor {
  static constexpr std::size_t kMostBytes = 8192;
  static constexpr std::size_t kHead = 64;
  static constexpr int kFewestFrames = 4;  // with fewer, caching is not worthwhile

  const mcpr_cooked* clip;
  std::int32_t first;     // first cached frame
  std::int32_t count;     // number of cached frames
  std::int32_t capacity;  // most frames that fit; 0: the cursor cannot cache frames
  std::int32_t columns;   // number of floats in a frame
  std::int32_t step;      // 2: every second frame is cached, for playing at half the rate
  std::int32_t last;      // the frame that was asked for last
  std::int32_t left_out;  // number of the finest bands left out of the cached frames
  // The frames follow as floats, kHead bytes after the start of this struct.

  /// Number of frames that fit into this many bytes; 0 if fewer than `fewest` fit.
  static int capacity_for(const mcpr_cooked& clip, std::size_t bytes = kMostBytes - kHead,
                          int fewest = kFewestFrames);
  static std::size_t bytes_for(const mcpr_cooked& clip);
  /// A cursor without cached frames.
  static mcpr_cursor empty(const mcpr_cooked& clip, std::size_t bytes = kMostBytes - kHead,
                           int fewest = kFewestFrames);
  /// Least work space for lifting, in 16-bit numbers: enough for the entries of one group, in all
  /// rows of all levels. With room for more groups, the entries are read less often.
  static constexpr int kFewestNumbers =
      mocapress::runtime::kGroup *
      (2 * mocapress::runtime::kMostLiftedFrames + 8 * mocapress::runtime::kMostKeptBands);

  const float* frame(int number) const {
    return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(this) + kHead) +
           std::ptrdiff_t{(number - first) / step} * columns;
  }

  /// Caches a frame and, with `and_next`, the next one. Neither may lie in an overlap of segments.
  /// Returns false if the cursor cannot cache frames. `work` has at least kFewestNumbers.
  bool keep(const mocapress::runtime::PoseKernels& kernels, int number, bool and_next,
            int left_out_bands, std::span<std::int16_t> work);

  /// Caches a run of frames. They must fit, and lie in one segment, outside overlaps.
  void keep_run(const mocapress::runtime::PoseKernels& kernels, int from, int frames,
                int left_out_bands, std::span<std::int16_t> work);

 private:
  bool has(int number) const {
    const int after = number - first;
    return after >= 0 && after < step * count && after % step == 0;
  }
  void fill(const mocapress::runtime::PoseKernels& kernels, int segment,
            std::span<std::int16_t> work);
};
