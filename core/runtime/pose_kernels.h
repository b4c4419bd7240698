// SPDX-License-Identifier: MIT
// The work on eight columns or eight joints at a time, in several instruction sets. Whole numbers
// are added exactly, and floats by the same operations in the same order without contraction: the
// bits of all paths agree.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/cooked_clip.h"

namespace mocapress::runtime {

/// The rows of a dense band that meet at an instant, bundle by bundle, each of all groups.
struct DenseRows {
  RowKind kind;
  const std::byte* rows;        // of the first bundle
  std::ptrdiff_t stride;        // bytes of a bundle
  const std::int16_t* weights;  // kDetailWindow, of crumbs kCrumbWindow
  int groups;
};

/// Columns from what was added up: offset + (sums of samples) * scale + whole * unit * step.
struct SampleRows {
  const std::byte* rows;  // of the first of kSampleWindow
  std::ptrdiff_t stride;  // bytes of a row
  const float* weights;   // kSampleWindow
  const float* scales;    // offset of each column, then scale, then step, an array each
  int columns_of_part;    // of each of these arrays
  const std::int32_t* whole;
  float unit;  // of them
  int groups;
  bool wide;  // floats, not 16 bits
  float* columns;
};

/// The weights of a band's rows, as they are used: as numbers of 16 bits, and of 32.
struct WholeWeights {
  const float* weights;  // kDetailWindow
  float scale;           // of those of 16 bits
  float entry_scale;     // of those of 32
  std::int16_t* of_row;
  std::int32_t* of_entry;
};

/// Quaternions of the eight joints of a group: w x y z, each of all eight.
struct RotorQuaternions {
  float of[4][kGroup];
};

struct PoseKernels {
  void (*add_rows)(const DenseRows&, std::int32_t* whole);
  void (*make_whole)(const WholeWeights&);
  void (*halve)(std::int32_t* whole, int groups);
  void (*make_columns)(const SampleRows&);
  /// `around`: 8 quaternions before, 8 after; null: none.
  void (*turn)(const RotorGroup&, const float* columns, const float* around, RotorQuaternions& out);
  /// Writes one quaternion w x y z each to 4 floats, of as many joints of a group as there are:
  /// to out + stride * joint.
  void (*put_quaternions)(const RotorGroup&, const RotorQuaternions&, float* out,
                          std::ptrdiff_t stride);
};

extern const PoseKernels kPlainPoses;
#if defined(__x86_64__) && defined(__GNUC__)
extern const PoseKernels kAvx2Poses;
#endif

/// Null where the build or the machine has none.
const PoseKernels* avx2_poses();

}  // namespace mocapress::runtime
