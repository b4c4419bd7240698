// SPDX-License-Identifier: MIT
// For forward play: the columns of some frames in a row, made by the inverse transform itself. What
// comes out is a function of the frame alone, whatever was asked for before.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

struct mcpr_cursor {
  static constexpr std::size_t kMostBytes = 4096;
  static constexpr std::size_t kHead = 64;
  static constexpr int kFewestFrames = 4;  // for fewer it is not worth it

  const mcpr_cooked* clip;
  std::int32_t first;     // frame that is kept
  std::int32_t count;     // of frames that are kept
  std::int32_t capacity;  // frames; 0: none is kept
  std::int32_t columns;   // of each
  std::int32_t step;      // 2: every second frame is kept, as is asked for in play at half the rate
  std::int32_t last;      // frame that was asked for
  std::int32_t left_out;  // of the finest bands, in what is kept
  // Then floats, frame after frame, kHead bytes from the beginning.

  /// Frames that fit into so many bytes; 0 where these are too few.
  static int capacity_for(const mcpr_cooked& clip, std::size_t bytes = kMostBytes - kHead,
                          int fewest = kFewestFrames);
  static std::size_t bytes_for(const mcpr_cooked& clip);
  /// Keeps none yet.
  static mcpr_cursor empty(const mcpr_cooked& clip, std::size_t bytes = kMostBytes - kHead,
                           int fewest = kFewestFrames);
  /// Rows of entries of all levels while frames are lifted: half of the frames, half of these ...,
  /// and some around them.
  static constexpr int most_entry_values(std::size_t bytes, int fewest) {
    const auto values = static_cast<int>(bytes / sizeof(float));
    return 2 * values + 8 * mocapress::runtime::kMostKeptBands * (values / fewest);
  }

  const float* frame(int number) const {
    return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(this) + kHead) +
           std::ptrdiff_t{(number - first) / step} * columns;
  }

  /// Sees to it that a frame is kept, and the next one if it is wanted too. They are not among
  /// those that two segments share. `left_out_bands`: of the finest. False: it keeps none.
  bool keep(const mocapress::runtime::PoseKernels& kernels, int number, bool and_next,
            int left_out_bands);

  /// Makes these frames, all of a segment and not shared, as many as fit. `entries`: room for
  /// most_entry_values().
  void keep_run(const mocapress::runtime::PoseKernels& kernels, int from, int frames,
                int left_out_bands, std::int32_t* entries);

 private:
  bool has(int number) const {
    const int after = number - first;
    return after >= 0 && after < step * count && after % step == 0;
  }
  void fill(const mocapress::runtime::PoseKernels& kernels, int segment, std::int32_t* entries);
};
