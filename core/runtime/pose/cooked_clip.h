// SPDX-License-Identifier: MIT
// The cooked form of a clip, in which the pose at any instant is a weighted sum of a few rows of
// small numbers. It is one little-endian block without pointers, the same in memory and on disk:
// SAMPLING.md describes it. A channel that changes has a column, which holds its values (half of
// them for angles). Eight columns are a group; consecutive groups that are stored in the same way
// are a part.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/bank_skeleton.h"
#include "core/runtime/format/bit_pattern.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/place_in_clip.h"
#include "core/runtime/format/segment_layout.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

inline constexpr int kGroup = 8;              // columns, or joints, that are processed together
inline constexpr int kMostGroupsOfPart = 16;  // so that 7 bits can number a column of a part
inline constexpr int kMostColumns = 4096;     // in a clip
inline constexpr int kDetailWindow = 8;  // most rows of a detail band that contribute to an instant
inline constexpr int kFinestWindow = 6;  // the same for the finest band
inline constexpr int kCrumbWindow = 12;  // the same for crumbs (2-bit numbers): a bundle of them
                                         // has four rows
inline constexpr int kSampleWindow = 6;  // most rows of samples that contribute to an instant
inline constexpr int kMostKeptBands = 5;  // most detail bands of a part
// Bit fields of an entry, see CookedEntries.
inline constexpr int kColumnBits = 7;
inline constexpr int kRowBits = 4;              // row number modulo 16
inline constexpr int kEntriesBeyond = 7;        // entries that may be read after a band's last one
inline constexpr int kSampleBytesBeyond = 4;    // bytes that may be read after the last samples
inline constexpr int kMostLog2RowsOfBlock = 3;  // the blocks of entries that contribute to an
                                                // instant span at most 16 rows

/// Storage of a band's detail rows: numbers of 2, 4, 8 or 16 bits. Rows are interleaved in bundles,
/// in the order in which the instructions that multiply pairs of numbers need them.
enum class RowKind : std::uint8_t { None, Crumbs, Nibbles, Bytes, Words };

/// Number of rows in a bundle.
constexpr int rows_together(RowKind kind) {
  return kind == RowKind::Crumbs ? 4 : 2;
}

/// Size in bytes of a bundle of rows, for one group of columns.
constexpr std::size_t bundle_bytes(RowKind kind) {
  switch (kind) {
    case RowKind::None:
      break;
    case RowKind::Crumbs:
    case RowKind::Nibbles:
      return 8;
    case RowKind::Bytes:
      return 16;
    case RowKind::Words:
      return 32;
  }
  return 0;
}

/// Number of bundles in a band of `rows` rows, with those that kernels may read beyond the last
/// row.
constexpr int bundles_of(RowKind kind, int rows) {
  const int even = rows < kDetailWindow ? kDetailWindow : (rows + 1) / 2 * 2;
  return kind == RowKind::Crumbs ? (even + 7) / 4 : even / 2;
}

/// The dense rows of a detail band of a part.
struct CookedBand {
  std::uint32_t rows = 0;  // offset from the clip
  RowKind kind = RowKind::None;
  std::uint8_t padding[3] = {};
};

/// Numbers to add to a band's dense rows, where these have too few bits; for up to
/// kMostGroupsOfPart groups of columns. An entry has 16 bits. From the lowest: column, row modulo
/// 16, signed value.
struct CookedEntries {
  std::uint32_t begins = 0;    // offset from the clip of: for each block, the index of its first
                               // entry (u16); the number of entries (u16); the entries
  std::uint16_t blocks = 0;    // 0: no entries
  std::uint8_t log2_rows = 0;  // logarithm of the number of rows in a block
  std::uint8_t padding = 0;
};

/// Consecutive groups of columns that are stored in the same way.
struct CookedPart {
  std::uint16_t first_group = 0;
  std::uint16_t groups = 0;
  std::uint8_t kept_bands = 0;      // number of detail bands, the finest ones; coarser bands become
                                    // samples
  std::uint8_t is_wide = 0;         // 1: samples have 24 bits, steps are floats; 0: samples have 16
  std::uint16_t narrow_groups = 0;  // number of groups, the first ones, whose samples have four
                                    // bits less

  /// Bits per sample in a group. A row has eight samples of the group, and so as many bytes.
  int sample_bits(int group) const {
    return (is_wide != 0 ? 24 : 16) - (group < narrow_groups ? 4 : 0);
  }
  /// Number of narrow groups among the groups `first` ... `end` - 1.
  int narrow_within(int first, int end) const {
    return std::clamp<int>(narrow_groups, first, end) - first;
  }
  /// Offset in bytes of a group's samples within a row. For group number `groups`: size of the
  /// whole row.
  std::ptrdiff_t sample_place(int group) const {
    return sample_bits(groups) * group - 4 * (group < narrow_groups ? group : narrow_groups);
  }
};

/// A part's data in one segment.
struct CookedRows {
  // Offset of three arrays with one element per column: the offset of samples, the scale of
  // samples, the quantisation step. Elements are upper halves of floats; but in a wide part, steps
  // are whole floats.
  std::uint32_t scales = 0;
  // Offset of the samples: row by row, and in a row group by group. They are signed integers,
  // stored as put_sample() does. A sample's value is offset + number * scale.
  std::uint32_t samples = 0;
  std::uint32_t bands = 0;  // offset of a CookedBand for each kept band, the finest first
  float unit = 0;           // factor on all steps
};

/// Size in bytes of `scales` for a number of columns.
constexpr std::uint64_t scale_bytes(bool is_wide, std::uint64_t columns) {
  return 2 * sizeof(std::uint16_t) * columns +
         (is_wide ? sizeof(float) : sizeof(std::uint16_t)) * columns;
}

/// Makes a float from its upper half.
inline float from_upper_half(std::uint16_t half) {
  return bit_pattern<float>(std::uint32_t{half} << 16);
}

/// Offset of a table, in bytes from `mcpr_cooked::tables`. The clips of a bank may share tables.
struct TableOffset {
  std::uint32_t bytes = 0;
};

/// Kind of the constant rotations before and after the rotations of a group's joints.
enum class AroundKind : std::uint8_t {
  None,
  // The rotations before and after are inverses of each other. The table has a 3 x 3 matrix per
  // joint, which maps the rotations about the first, second and third axis to x, y and z. It has
  // each number for all eight joints, then the next number.
  Inverses,
  Any,  // two quaternions w x y z per joint, before and after; each number for all eight joints
};

/// Number of floats in a group's table.
constexpr std::uint64_t floats_around(AroundKind kind) {
  if (kind == AroundKind::None) return 0;
  return (kind == AroundKind::Inverses ? 9 : 8) * std::uint64_t{kGroup};
}

/// Eight joints, each of which rotates about up to three different axes.
struct RotorGroup {
  std::uint16_t joint[kGroup] = {};  // kNoJoint: no joint at this place
  std::uint16_t vector[3] = {};  // numbers of the groups of columns that have the first, second and
                                 // third half angles
  std::uint8_t angles = 0;       // 1 to 3: number of vectors in use
  std::uint8_t joints = 0;       // number of joints in `joint`
  std::uint8_t has_angle[3] = {};    // for each vector: one bit per joint that has this angle
  std::uint8_t is_odd = 0;           // one bit per joint: its axes are an odd permutation of x y z
  std::uint8_t first_axis[3] = {};   // for x, y and z: one bit per joint whose first axis that is
  std::uint8_t second_axis[3] = {};  // the same for the second axis; the third is the remaining
                                     // axis
  AroundKind around_kind = AroundKind::None;
  std::uint8_t are_near = 0;  // one bit per vector: set if all its half angles stay within an
                              // eighth of a turn
  TableOffset around = {};
  static constexpr std::uint16_t kNoJoint = 0xFFFF;
};

/// A translation channel that changes.
struct MovingAxis {
  std::uint16_t joint = 0;
  std::uint16_t axis = 0;
  std::uint32_t column = 0;
};

/// A column whose values are added to another column.
struct AddedColumn {
  std::uint16_t from = 0;
  std::uint16_t to = 0;
};

/// A factor of the rotation of a joint that is in no RotorGroup: a rotation about one axis, or a
/// constant rotation.
struct OtherTurn {
  std::uint16_t joint = 0;
  std::uint16_t axis = 0;  // 0 1 2: x y z; kConstant: `column` is the TableOffset of a quaternion
  std::uint32_t column = 0;
  static constexpr std::uint16_t kConstant = 3;
};

/// The way a column continues after the last frame of a loop: straight to its first value, by the
/// shorter way round, or by repeating its last step.
enum class ColumnKind : std::uint8_t { Straight, HalfAngle, Root };

}  // namespace mocapress::runtime

struct mcpr_cooked {
  static constexpr char kMagic[4] = {'M', 'C', 'P', 'C'};
  static constexpr std::uint32_t kVersion = 8;
  char magic[4];
  std::uint32_t checksum;  // CRC-32 of `bytes`, and of everything from `version` on
  std::uint64_t bytes;     // size of the clip
  std::int64_t tables;     // offset from the clip of the block that table offsets count from; 0
                           // outside banks. Not in the checksum
  std::uint32_t version;
  std::uint32_t skeleton_bytes;  // the part of `bytes` that does not grow with the motion
  double sample_rate;            // frames per second
  std::uint32_t frames;
  std::uint32_t segment_length;
  std::uint32_t segment_overlap;
  std::uint32_t joints;
  std::uint32_t groups;      // groups of columns
  std::uint32_t row_groups;  // number of groups with rows, the first ones; the others copy values
                             // of columns
  std::uint16_t parts;
  std::uint16_t segments;
  std::uint16_t rotor_groups;
  std::uint16_t moving_axes;
  std::uint16_t added_columns;
  std::uint16_t other_turns;
  mocapress::runtime::Wavelet wavelet;
  mocapress::runtime::LoopKind loop;
  mocapress::runtime::EndReaches end_reaches;  // as in ENDS of FORMAT.md
  std::uint8_t has_skeleton;  // 1: after the head come the size of a skeleton item (u32), and the
                              // item
  std::uint8_t unused;
  float end_units[mocapress::runtime::kMostEnds];
  mocapress::runtime::TableOffset rest;    // an mcpr_transform per joint: the parts of it that are
                                           // constant
  mocapress::runtime::TableOffset rotors;  // RotorGroup array
  mocapress::runtime::TableOffset moving;  // MovingAxis array
  mocapress::runtime::TableOffset added;   // AddedColumn array
  mocapress::runtime::TableOffset turns;   // OtherTurn array
  mocapress::runtime::TableOffset bases;  // floats: initial values of the columns that have no rows
  mocapress::runtime::TableOffset part_table;    // CookedPart array
  mocapress::runtime::TableOffset column_kinds;  // ColumnKind array; only for loops of kind Follows
  // The following are offsets from the clip.
  std::uint32_t ends;  // for each end correction: a byte per group of columns, with a bit per
                       // column that it changes; then, for each end correction: an i16 per column
                       // with a bit, in units of end_units * step
  std::uint32_t rows;  // CookedRows of each part, segment by segment
  std::uint32_t entries;  // for each segment, and in it for each kMostGroupsOfPart groups:
                          // CookedEntries of kMostKeptBands bands, the finest first
  std::uint32_t tracks;   // mcpr_tracks; 0: the clip has none

  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
  template <typename T>
  const T* at(mocapress::runtime::TableOffset offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + tables +
                                      offset.bytes);
  }
  const std::uint8_t* end_marks(int end) const {
    return at<std::uint8_t>(ends) + static_cast<std::uint32_t>(end) * row_groups;
  }
  /// Number of values in the end corrections before correction `end`.
  std::uint32_t lacking_before(int end) const {
    std::uint32_t count = 0;
    for (const std::uint8_t* mark = end_marks(0); mark != end_marks(end); ++mark)
      count += static_cast<std::uint32_t>(std::popcount(*mark));
    return count;
  }
  std::uint32_t end_values() const {
    const auto marks = static_cast<std::uint32_t>(end_reaches.count()) * row_groups;
    return (ends + marks + 1) / 2 * 2;
  }
  mocapress::runtime::SegmentLayout layout() const {
    return {static_cast<int>(frames), static_cast<int>(segment_length),
            static_cast<int>(segment_overlap)};
  }
  const mocapress::runtime::CookedPart& part(int p) const {
    return at<mocapress::runtime::CookedPart>(part_table)[p];
  }
  const mocapress::runtime::CookedRows& rows_of(int segment, int p) const {
    return at<mocapress::runtime::CookedRows>(rows)[segment * parts + p];
  }
  /// Number of sets of groups. A set has kMostGroupsOfPart groups, and entries of its own.
  int entry_parts() const {
    constexpr auto kMost = static_cast<std::uint32_t>(mocapress::runtime::kMostGroupsOfPart);
    return static_cast<int>((row_groups + kMost - 1) / kMost);
  }
  const mocapress::runtime::CookedEntries& entries_of(int segment, int entry_part, int band) const {
    return at<mocapress::runtime::CookedEntries>(
        entries)[(segment * entry_parts() + entry_part) * mocapress::runtime::kMostKeptBands +
                 band];
  }
  /// The joints' names, parents and offsets; without joints if these were not kept.
  mocapress::runtime::BankSkeleton skeleton() const {
    if (has_skeleton == 0) return mocapress::runtime::BankSkeleton({nullptr, 0, 0});
    std::uint32_t size = 0;
    std::memcpy(&size, this + 1, sizeof size);
    return mocapress::runtime::BankSkeleton(
        {at<std::uint8_t>(skeleton_item()), size, skeleton_item()});
  }
  static constexpr std::uint32_t skeleton_item() {
    return static_cast<std::uint32_t>(sizeof(mcpr_cooked) + sizeof(std::uint32_t));
  }
  int turn_frames() const {
    return mocapress::runtime::turn_frames_of(static_cast<int>(frames), loop);
  }
  mocapress::runtime::Wrapping wrapping(mcpr_wrap wrap) const {
    return {static_cast<int>(frames), loop, wrap};
  }
};

namespace mocapress::runtime {

/// True if the first bytes are those of a cooked clip.
inline bool is_cooked(const mcpr_cooked* clip) {
  return clip != nullptr && std::memcmp(clip->magic, mcpr_cooked::kMagic, sizeof clip->magic) == 0;
}

}  // namespace mocapress::runtime
