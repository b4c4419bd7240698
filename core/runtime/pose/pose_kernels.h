// SPDX-License-Identifier: MIT
// Operations on eight columns or eight joints at a time, for several instruction sets. All of them
// give the same bits: integers are added exactly, and floats by the same operations in the same
// order, without contraction to fused multiply-adds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Integer weights of the rows of a band.
struct BandWeights {
  int first_row;   // an even number
  int first_used;  // this and the next: first and last row that may have a nonzero weight
  int last_used;
  std::int32_t sum;  // sum of `of_row`
  // Weights of the window's rows, times 2^15, and times another 2 for every second band from the
  // finest on, for precision. The zeros before and after complete the window of crumbs, which
  // starts at a multiple of four. In the finest band only kFinestWindow rows have weights.
  alignas(16) std::int16_t of_row[2 + kDetailWindow + 4] = {};
  // Weights times 2^17. The weight of a row is at the row's number modulo 16; all other elements
  // are zero.
  alignas(32) std::int32_t of_entry[16];
};

/// Input and output of make_columns(), for consecutive groups of one part. A column is offset +
/// (weighted sum of samples) * scale + (weighted sum of details) * unit * step.
struct PartRows {
  const std::byte* clip;                // base of the bands' offsets
  const CookedBand* bands;              // the finest first
  const BandWeights* weights_of_bands;  // in the same order as `bands`
  int first_band;                       // finer bands are left out
  int kept_bands;
  const std::byte* samples;  // samples of the first group, in the first of kSampleWindow rows
  std::ptrdiff_t row_bytes;  // distance from one of these rows to the next
  const float* weights;      // weights of these rows, one each
  int groups_of_part;
  int first_group;  // number of the first group within the part
  int groups;
  int narrow;  // number of groups, the first ones, whose samples have four bits less
  bool wide;   // samples have 24 bits instead of 16
  float unit;  // factor on all steps
  const std::int32_t* entries;  // weighted sums of the entries, for the columns of these groups
  const std::byte* scales;      // CookedRows::scales
  float* columns;               // output, for the columns of these groups
};

/// Entries of consecutive blocks of a band.
struct EntryRun {
  const std::uint16_t* first;
  int count;
};

/// The entries of the blocks that contain rows with weights.
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

/// One level of the inverse transform: makes some samples from even samples and details.
struct LiftLevel {
  Wavelet wavelet = Wavelet::Haar;
  int even_count = 0;  // number of even samples in the whole signal
  int odd_count = 0;
  bool only_evens = false;   // make even samples only
  bool is_left_out = false;  // treat the details as zero
  RowRange samples = {};
  RowRange evens = {};
  RowRange details = {};
  const std::int16_t* entries = nullptr;  // added to the details, row by row
};

inline constexpr int kMostLiftedFrames = 32;

/// Consecutive frames to compute, for consecutive groups of one part.
struct LiftPart {
  const LiftLevel* levels;  // the finest first
  int level_count;
  const CookedBand* bands;   // one per level
  const std::byte* clip;     // base of the bands' offsets
  const std::byte* samples;  // samples of the first group, in the first wanted row
  std::ptrdiff_t row_bytes;  // distance from one row to the next
  int sample_count;          // number of rows, from the first wanted one to the last
  int sample_step;           // distance between wanted rows, in rows
  float unit;                // factor on all steps
  const std::byte* scales;   // CookedRows::scales
  int groups_of_part;
  int first_group;  // number of the first group within the part
  int groups;
  int narrow;  // number of groups, the first ones, whose samples have four bits less
  bool wide;
  int first_entry;    // column of the first group in the rows of entries
  int entry_columns;  // number of columns in these rows
  float* frames;      // output, for the columns of these groups
  int frame_columns;  // distance from one frame to the next, in floats
};

/// Quaternions of the eight joints of a group: w of all joints, then x, y, z.
struct RotorQuaternions {
  float of[4][kGroup];
};

struct PoseKernels {
  /// Rounds weights to integers. `weights` has the weights of the window's rows at a frame, then
  /// the differences to the next frame, which are added with factor `share`. All are multiplied by
  /// scale_of_band(). The weights of entries are shifted by `shift`. The row numbers in BandWeights
  /// must be set before.
  void (*set_band)(const float* weights, float share, int shift, BandWeights&);
  /// For the given groups, sums the entries of `count` bands, the finest first, each multiplied by
  /// the weight of its row. May read up to kEntriesBeyond entries after the last one of a band.
  void (*sum_entries)(const std::byte* clip, const CookedEntries* bands, const BandWeights* weights,
                      int count, int groups, std::int32_t* whole);
  void (*make_columns)(const PartRows&);
  /// out = from + share * (to - from), for `count` floats, a multiple of eight.
  void (*blend)(const float* from, const float* to, float share, int count, float* out);
  void (*lift)(const LiftPart&);
  /// Computes the rotations of a group's joints. `around` is the table that AroundKind describes.
  void (*turn)(const RotorGroup&, const float* columns, const float* around, RotorQuaternions& out);
  /// Like turn(), but for the first `joints` joints only, and writes the quaternion w x y z of each
  /// to out + 8 * its place.
  void (*turn_into)(const RotorGroup&, const float* columns, const float* around,
                    const std::uint16_t* places, int joints, float* out);
};

/// The kernels of a path; null if the build or the machine does not have it.
const PoseKernels* poses_of(mcpr_path path);

// Each exists only in builds that have it.
extern const PoseKernels kPlainPoses;
extern const PoseKernels kFourPoses;
extern const PoseKernels kAvx2Poses;

}  // namespace mocapress::runtime
