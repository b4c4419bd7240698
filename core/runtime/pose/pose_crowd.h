// SPDX-License-Identifier: MIT
// Many characters at once. Sorted by clip and instant, one clip's tables, rows and branches are
// used one after the other; and where instants of a clip are dense, frames are lifted once for
// many, as a cursor does.
#pragma once

#include <cstdint>

#include "core/runtime/format/memory.h"
#include "core/runtime/pose/pose_cursor.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// What one of them asks for.
mcpr_sample_request request_of(const mcpr_crowd_request& request, const mcpr_character& character);

/// Puts characters into order, in place.
class CrowdSorter {
 public:
  /// With measuring memory only to know how much.
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

/// Poses characters one after the other, in any order.
class PoseCrowd {
 public:
  /// With measuring memory only to know how much.
  explicit PoseCrowd(Memory& memory);

  void pose(const mcpr_crowd_request& request, const mcpr_character* characters,
            std::uint32_t count);

 private:
  static constexpr std::uint32_t kAhead =
      256;  // characters that are looked at before they are posed
  static constexpr std::size_t kFrameBytes = 16384;  // of lifted frames
  static constexpr int kFewestLifted = 8;            // of them that fit, or none is lifted
  static constexpr int kMostEntryValues =
      mcpr_cursor::most_entry_values(kFrameBytes, kFewestLifted);

  /// Where a character is.
  struct Spot {
    double frame;
    float across;
    std::int32_t before;  // the first frame that it needs, and the last;
    std::int32_t last;    // below `before` where none can be lifted for it
  };
  /// Characters for whom the same frames are lifted.
  struct Together {
    std::uint32_t count = 0;
    int last = 0;  // frame
  };
  static Spot spot_of(const mcpr_crowd_request& request, const mcpr_character& character);
  Together together(const mcpr_character* characters, std::uint32_t first, std::uint32_t end) const;

  mcpr_cursor* frames_;
  std::int32_t* entries_;
  Spot* spots_;
};

}  // namespace mocapress::runtime
