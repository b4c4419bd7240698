// SPDX-License-Identifier: MIT
// Operations on eight columns or eight joints at a time, for several instruction sets. Integers are
// added exactly, and floats by the same operations in the same order without contraction, so that
// all paths give the same bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Integer weights of a band's rows.
struct BandWeights {
  int first_row;   // an even number
  int first_used;  // this and `last_used`: first and last row that may have a nonzero weight
  int last_used;
  std::int32_t sum;  // sum of `of_row`
  // Weights times 2^15, and times another 2 for every second band from the finest, so that
  // precision is kept. Zeros before and after them complete the window of crumbs, which starts at a
  // multiple of four. In the finest band the rows after kFinestWindow are zero.
  alignas(16) std::int16_t of_row[2 + kDetailWindow + 4] = {};
  // Weights times 2^17, at the row's number modulo 16. All other elements are zero.
  alignas(32) std::int32_t of_entry[16];
};

/// Input and output of make_columns(), for a range of groups in one part. A column is offset + (sum
/// of samples) * scale + (sum of details) * unit * step.
struct PartRows {
  const std::byte* clip;                // base of the bands' offsets
  const CookedBand* bands;              // the finest first
  const BandWeights* weights_of_bands;  // in the same order
  int first_band;                       // finer bands are left out
  int kept_bands;
  const std::byte* samples;  // first group in the first of kSampleWindow rows
  std::ptrdiff_t row_bytes;  // from one of these rows to the next
  const float* weights;      // weights of these rows
  int groups_of_part;
  int first_group;  // within the part
  int groups;
  int narrow;                   // the first of them, whose samples have four bits less
  bool wide;                    // samples have 24 bits instead of 16
  float unit;                   // factor on all steps
  const std::int32_t* entries;  // sums of the entries, for the columns from the first group on
  const std::byte* scales;      // CookedRows::scales
  float* columns;               // output, from the first group on
};

/// Entries of consecutive blocks.
struct EntryRun {
  const std::uint16_t* first;
  int count;
};

/// The entries of the blocks that the weighted rows are in.
inline EntryRun run_of(const std::byte* clip, const CookedEntries& entries,
                       const BandWeights& weights) {
  const auto* const begins = reinterpret_cast<const std::uint16_t*>(clip + entries.begins);
  const int first = std::min(weights.first_used >> entries.log2_rows, int{entries.blocks});
  const int end = std::min((weights.last_used >> entries.log2_rows) + 1, int{entries.blocks});
  return {begins + entries.blocks + 1 + begins[first],
          begins[std::max(first, end)] - begins[first]};
}

struct RowRange {
  int first = 0;
  int end = 0;
};

/// One level of the inverse transform: makes a range of samples from ranges of even samples and
/// details.
struct LiftLevel {
  Wavelet wavelet = Wavelet::Haar;
  int even_count = 0;  // number of even samples in the whole signal
  int odd_count = 0;
  bool only_evens = false;   // make even samples only
  bool is_left_out = false;  // treat details as zero
  RowRange samples = {};
  RowRange evens = {};
  RowRange details = {};
  const std::int16_t* entries = nullptr;  // added to the details, row by row
};

inline constexpr int kMostLiftedFrames = 32;

/// Consecutive frames of a range of groups in one part.
struct LiftPart {
  const LiftLevel* levels;  // the finest first
  int level_count;
  const CookedBand* bands;   // one per level
  const std::byte* clip;     // base of the bands' offsets
  const std::byte* samples;  // first group in the first wanted row
  std::ptrdiff_t row_bytes;  // from one row to the next
  int sample_count;          // rows up to the last wanted one
  int sample_step;           // distance between wanted sample rows
  float unit;                // factor on all steps
  const std::byte* scales;   // CookedRows::scales
  int groups_of_part;
  int first_group;  // within the part
  int groups;
  int narrow;  // the first of them, whose samples have four bits less
  bool wide;
  int first_entry;    // the first group's place in rows of entries
  int entry_columns;  // columns of these rows
  float* frames;      // output, from the first group on
  int frame_columns;  // from one frame to the next
};

/// Quaternions of the eight joints of a group: w of all joints, then x, y, z.
struct RotorQuaternions {
  float of[4][kGroup];
};

struct PoseKernels {
  /// Rounds weights to integers: those at a frame, plus `share` times the differences to the next
  /// frame, which follow them. Both are multiplied by scale_of_band(). The weights of entries are
  /// shifted by `shift`. The rows in BandWeights must be set.
  void (*set_band)(const float* weights, float share, int shift, BandWeights&);
  /// Sums the entries of bands, the finest first, over the given groups: each value times the
  /// weight of its row. May read up to kEntriesBeyond entries after a band's last.
  void (*sum_entries)(const std::byte* clip, const CookedEntries* bands, const BandWeights* weights,
                      int count, int groups, std::int32_t* whole);
  void (*make_columns)(const PartRows&);
  /// out = from + share * (to - from); `count` is a multiple of eight.
  void (*blend)(const float* from, const float* to, float share, int count, float* out);
  void (*lift)(const LiftPart&);
  /// `around` is the table that the group's AroundKind describes.
  void (*turn)(const RotorGroup&, const float* columns, const float* around, RotorQuaternions& out);
  /// Does what turn() does for the first `joints` joints; writes w x y z of each to out + 8 *
  /// place.
  void (*turn_into)(const RotorGroup&, const float* columns, const float* around,
                    const std::uint16_t* places, int joints, float* out);
};

/// Null if the build or the machine does not have the path.
const PoseKernels* poses_of(mcpr_path path);

// Each only if the build has it.
extern const PoseKernels kPlainPoses;
extern const PoseKernels kFourPoses;
extern const PoseKernels kAvx2Poses;

}  // namespace mocapress::runtime
