// SPDX-License-Identifier: MIT
// Poses many characters. If they are sorted by clip and instant, a clip's tables and rows stay in
// the caches, and branches are predicted well. Where several characters need nearby frames of one
// clip, these frames are lifted (computed by the inverse transform) once for all of them, as a
// cursor does.
#pragma once

#include <cstdint>

#include "core/runtime/format/memory.h"
#include "core/runtime/pose/pose_cursor.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// The sample request that poses one character.
mcpr_sample_request request_of(const mcpr_crowd_request& request, const mcpr_character& character);

/// Sorts characters in place.
class CrowdSorter {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  CrowdSorter(Memory& memory, std::uint32_t count);

  void sort(const mcpr_crowd_request& request, mcpr_character* characters);

 private:
  struct Key {
    std::uint64_t order;
    std::uint32_t number;
  };
  void sort_keys();

  std::uint32_t count_;
  Key* keys_;
  Key* other_keys_;
  mcpr_character* sorted_;
};

/// Poses characters in the order of the array.
class PoseCrowd {
 public:
  /// If `memory` only measures, this counts bytes and does nothing else.
  explicit PoseCrowd(Memory& memory);

  void pose(const mcpr_crowd_request& request, const mcpr_character* characters,
            std::uint32_t count);

 private:
  static constexpr std::uint32_t kAhead = 256;       // number of characters that are looked at in
                                                     // advance
  static constexpr std::size_t kFrameBytes = 16384;  // memory for lifted frames
  static constexpr int kFewestLifted = 8;  // no frames are lifted if fewer than this many fit
  // Work space for lifting, large enough to read the entries of most clips only once.
  static constexpr std::size_t kLiftingNumbers = 12 * kFrameBytes / sizeof(float);
  /// The instant of a character.
  struct Spot {
    double frame;
    float across;
    std::int32_t before;  // first frame that the pose needs
    std::int32_t last;    // last frame that the pose needs; less than `before` if its frames cannot
                          // be lifted
  };
  /// Consecutive characters that share lifted frames.
  struct Together {
    std::uint32_t count = 0;
    int last = 0;  // last lifted frame
  };
  static Spot spot_of(const mcpr_crowd_request& request, const mcpr_character& character);
  Together together(const mcpr_character* characters, std::uint32_t first, std::uint32_t end) const;

  mcpr_cursor* frames_;
  std::int16_t* lifting_;
  std::byte* posing_;
  Spot* spots_;
};

}  // namespace mocapress::runtime
