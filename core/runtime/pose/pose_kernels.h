// SPDX-License-Identifier: MIT
// The work on eight columns or eight joints at a time, in several instruction sets. Whole numbers
// are added exactly, and floats by the same operations in the same order without contraction: the
// bits of all paths agree.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// The weights of a band's rows as whole numbers.
struct BandWeights {
  int first_row;   // even
  int first_used;  // the first that may not be zero, and the last
  int last_used;
  std::int32_t sum;  // of `of_row`
  // Times 2^15 and, so that none gets lost, once more 2 for every second band from the finest.
  // Zeros before and after them make up a window of crumbs, which begins at a fourth row. Of the
  // finest band those after kFinestWindow are zero.
  alignas(16) std::int16_t of_row[2 + kDetailWindow + 4] = {};
  // Times 2^17, each row's at its number modulo 16; the other rows of blocks have zeros.
  alignas(32) std::int32_t of_entry[16];
};

/// What the columns of a part, or of some groups of it, are made of: offset +
/// (sums of samples) * scale + (sums of details) * unit * step.
struct PartRows {
  const std::byte* clip;                // which the offsets of bands are from
  const CookedBand* bands;              // the finest first
  const BandWeights* weights_of_bands;  // likewise
  int first_band;                       // from which on they are added up
  int kept_bands;
  const std::byte* samples;  // of row 0
  int first_sample;          // of kSampleWindow rows
  const float* weights;      // of these
  int groups_of_part;
  int first_group;  // in the part
  int groups;
  bool wide;                    // samples are floats, not 16 bits
  float unit;                   // of details
  const std::int32_t* entries;  // what they add up to, from the first group on
  const std::byte* scales;      // CookedRows::scales
  float* columns;               // from the first group on
};

/// Entries of blocks that lie one after the other.
struct EntryRun {
  const std::uint16_t* first;
  int count;
};

/// Those of the blocks that the rows are in.
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

/// A step of the inverse transform: samples from evens and details, in these ranges.
struct LiftLevel {
  Wavelet wavelet = Wavelet::Haar;
  int even_count = 0;  // of the whole signal
  int odd_count = 0;
  bool only_evens = false;   // of the samples the even ones
  bool is_left_out = false;  // details are zero
  RowRange samples = {};
  RowRange evens = {};
  RowRange details = {};
  const std::int32_t* entries = nullptr;  // what they add to the details, rows of all columns
};

inline constexpr int kMostLiftedFrames = 32;

/// Frames in a row of the columns of a part.
struct LiftPart {
  const LiftLevel* levels;  // the finest first
  int level_count;
  const CookedBand* bands;   // of these levels
  const std::byte* clip;     // which their offsets are from
  const std::byte* samples;  // of row 0
  RowRange sample_rows;
  int sample_step;          // from one that is wanted to the next
  float unit;               // of steps
  const std::byte* scales;  // CookedRows::scales
  int groups;
  bool wide;
  int first_column;  // in `frames` and rows of entries
  int row_columns;   // of these
  float* frames;
};

/// Quaternions of the eight joints of a group: w x y z, each of all eight.
struct RotorQuaternions {
  float of[4][kGroup];
};

struct PoseKernels {
  /// A band's weights and a share of as many that follow, times the scale of the band; its rows are
  /// set already. Those of entries are times 2^shift.
  void (*set_band)(const float* weights, float share, int shift, BandWeights&);
  /// What the entries of some bands, the finest first, and as many groups of columns add up to: the
  /// value of each that meets times its row's weight. Up to kEntriesBeyond entries after the last
  /// of a band are read, too.
  void (*sum_entries)(const std::byte* clip, const CookedEntries* bands, const BandWeights* weights,
                      int count, int groups, std::int32_t* whole);
  void (*make_columns)(const PartRows&);
  void (*clear)(std::int32_t* values, int count);  // of a multiple of eight
  /// out = from + share * (to - from), likewise.
  void (*blend)(const float* from, const float* to, float share, int count, float* out);
  void (*lift)(const LiftPart&);
  /// `around`: what the group's AroundKind says.
  void (*turn)(const RotorGroup&, const float* columns, const float* around, RotorQuaternions& out);
  /// The same, written for the first so many joints, w x y z each: to out + 8 * place.
  void (*turn_into)(const RotorGroup&, const float* columns, const float* around,
                    const std::uint16_t* places, int joints, float* out);
};

extern const PoseKernels kPlainPoses;
#if defined(__x86_64__) && defined(__GNUC__)
extern const PoseKernels kAvx2Poses;
#endif

/// Null where the build or the machine has none.
const PoseKernels* avx2_poses();

}  // namespace mocapress::runtime
