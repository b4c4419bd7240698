// SPDX-License-Identifier: MIT
// The cooked form of a clip: laid out so that the pose of any instant is a weighted sum of some
// rows of small numbers. One block of bytes without pointers, little-endian, the same in memory and
// on disk: SAMPLING.md describes it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/format/segment_layout.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

inline constexpr int kGroup = 8;              // columns, and joints, that are worked on together
inline constexpr int kMostGroupsOfPart = 16;  // so that 7 bits tell a column of a part
inline constexpr int kMostColumns = 4096;     // of a clip; sampling keeps them on the stack
inline constexpr int kDetailWindow = 8;       // rows of a band of details that meet at an instant
inline constexpr int kFinestWindow = 6;       // the same of the finest band
inline constexpr int kCrumbWindow = 12;       // the same of crumbs, which lie four together
inline constexpr int kSampleWindow = 6;       // rows of samples that meet
inline constexpr int kMostKeptBands = 5;      // bands of details of a part
// Of an entry that is added to a band's rows.
inline constexpr int kColumnBits = 7;
inline constexpr int kRowBits = 4;              // its row modulo 16
inline constexpr int kEntriesBeyond = 7;        // read after the last of a band
inline constexpr int kMostLog2RowsOfBlock = 3;  // those that meet have 16 rows at most

/// How the rows of a band of details are kept: in 2, 4, 8 or 16 bits. Some rows lie in each other,
/// a number of the one beside that of the next, as the instructions that multiply pairs want them.
enum class RowKind : std::uint8_t { None, Crumbs, Nibbles, Bytes, Words };

/// Rows that lie in each other.
constexpr int rows_together(RowKind kind) {
  return kind == RowKind::Crumbs ? 4 : 2;
}

/// Bytes of these rows, of a group.
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

/// How many of them a band of so many rows has, with what is read beyond the last.
constexpr int bundles_of(RowKind kind, int rows) {
  const int even = rows < kDetailWindow ? kDetailWindow : (rows + 1) / 2 * 2;
  return kind == RowKind::Crumbs ? (even + 7) / 4 : even / 2;
}

/// The dense rows of a band of details of one part.
struct CookedBand {
  std::uint32_t rows = 0;  // offset from the clip
  RowKind kind = RowKind::None;
  std::uint8_t padding[3] = {};
};

/// What is added to a band's dense rows, of up to kMostGroupsOfPart groups of columns: entries of
/// 16 bits, from the lowest a column of these, its row modulo 16, and a value with sign.
struct CookedEntries {
  std::uint32_t begins = 0;    // offset from the clip: where each block of rows begins among the
                               // entries, as u16, and the end; then the entries
  std::uint16_t blocks = 0;    // 0: there are no entries
  std::uint8_t log2_rows = 0;  // of a block
  std::uint8_t padding = 0;
};

/// Columns that are worked on together.
struct CookedPart {
  std::uint16_t first_group = 0;
  std::uint16_t groups = 0;
  std::uint8_t kept_bands = 0;    // of details, the finest; coarser ones are made samples of
  std::uint8_t wide_samples = 0;  // 1: samples are floats; 0: 16 bits
  std::uint16_t padding = 0;
};

/// A part in one segment.
struct CookedRows {
  // Of each column, an array each: offset, scale of samples and step, each the upper half of a
  // float; where samples are floats only the step, a float.
  std::uint32_t scales = 0;
  std::uint32_t samples = 0;  // row after row
  std::uint32_t bands = 0;    // CookedBand of each kept one, the finest first
  float unit = 0;             // of steps
};

/// Bytes of `scales`, of so many columns.
constexpr std::uint64_t scale_bytes(bool wide_samples, std::uint64_t columns) {
  return (wide_samples ? sizeof(float) : 3 * sizeof(std::uint16_t)) * columns;
}

/// A float from its upper half.
inline float from_upper_half(std::uint16_t half) {
  return std::bit_cast<float>(std::uint32_t{half} << 16);
}

/// Where a table is that clips of a bank may share: bytes from `mcpr_cooked::tables` on.
struct TableOffset {
  std::uint32_t bytes = 0;
};

/// What is before and after the axes of a group of joints.
enum class AroundKind : std::uint8_t {
  None,
  // Each other's inverses: 3 x 3 numbers, each of all eight joints, that turn what is about the
  // first, second and third axis into what is about x, y and z.
  Inverses,
  Any,  // 4 numbers of quaternions before, then 4 after, w x y z, each of all eight
};

/// How many numbers that is.
constexpr std::uint64_t floats_around(AroundKind kind) {
  if (kind == AroundKind::None) return 0;
  return (kind == AroundKind::Inverses ? 9 : 8) * std::uint64_t{kGroup};
}

/// Eight joints that turn about up to three different axes each.
struct RotorGroup {
  std::uint16_t joint[kGroup] = {};  // kNoJoint: none
  std::uint16_t vector[3] = {};      // of the first, second and third half angles
  std::uint8_t angles = 0;           // 1 .. 3: how many of the three there are
  std::uint8_t joints = 0;           // the first of `joint` that are there
  std::uint8_t has_angle[3] = {};    // a bit for each joint
  std::uint8_t is_odd = 0;           // whether its axes are an odd permutation of x y z
  std::uint8_t first_axis[3] = {};   // a bit for each joint whose first axis is x, y, z
  std::uint8_t second_axis[3] = {};  // the same of the second; the third is what is left
  AroundKind around_kind = AroundKind::None;
  std::uint8_t are_near = 0;  // a bit for each of `vector` whose half angles are all within an
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

/// A column that is to be added to another.
struct AddedColumn {
  std::uint16_t from = 0;
  std::uint16_t to = 0;
};

/// A factor of the rotation of a joint that is in no group: about an axis, or constant.
struct OtherTurn {
  std::uint16_t joint = 0;
  std::uint16_t axis = 0;  // 0 1 2: x y z; kConstant: `column` is a TableOffset of a quaternion
  std::uint32_t column = 0;
  static constexpr std::uint16_t kConstant = 3;
};

/// How a column goes on from the last frame of a loop to the first.
enum class ColumnKind : std::uint8_t { Straight, HalfAngle, Root };

}  // namespace mocapress::runtime

struct mcpr_cooked {
  static constexpr char kMagic[4] = {'M', 'C', 'P', 'C'};
  static constexpr std::uint32_t kVersion = 7;
  char magic[4];
  std::uint32_t checksum;  // CRC-32 of `bytes` and all from `version` on
  std::uint64_t bytes;     // of all
  std::int64_t tables;  // where tables are counted from, as bytes from the clip: 0, but in a bank;
                        // not in the checksum
  std::uint32_t version;
  std::uint32_t skeleton_bytes;  // of them what does not depend on the motion's length
  double sample_rate;            // frames a second
  std::uint32_t frames;
  std::uint32_t segment_length;
  std::uint32_t segment_overlap;
  std::uint32_t joints;
  std::uint32_t groups;      // of columns
  std::uint32_t row_groups;  // of them: the first, of which there are rows
  std::uint16_t parts;
  std::uint16_t segments;
  std::uint16_t rotor_groups;
  std::uint16_t moving_axes;
  std::uint16_t added_columns;
  std::uint16_t other_turns;
  mocapress::runtime::Wavelet wavelet;
  mocapress::runtime::LoopKind loop;
  mocapress::runtime::EndReaches end_reaches;  // as ENDS of FORMAT.md has them
  std::uint8_t unused[2];
  float end_units[mocapress::runtime::kMostEnds];
  mocapress::runtime::TableOffset rest;    // mcpr_transform of each joint: of what never changes
  mocapress::runtime::TableOffset rotors;  // RotorGroup
  mocapress::runtime::TableOffset moving;  // MovingAxis
  mocapress::runtime::TableOffset added;   // AddedColumn
  mocapress::runtime::TableOffset turns;   // OtherTurn
  mocapress::runtime::TableOffset bases;   // floats: what the columns without rows begin with
  mocapress::runtime::TableOffset part_table;    // CookedPart
  mocapress::runtime::TableOffset column_kinds;  // ColumnKind; only of a loop whose first frame
                                                 // follows the last
  // Offsets from the clip.
  std::uint32_t ends;     // of each end that has a reach: a byte for each group of columns, a bit
                          // for each column in which it lacks something; then, of these: i16, in
                          // end_units of the column's step, end after end
  std::uint32_t rows;     // CookedRows of each part, segment after segment
  std::uint32_t entries;  // CookedEntries of each of kMostKeptBands, the finest first, of each
                          // kMostGroupsOfPart groups, segment after segment
  std::uint32_t tracks;   // mcpr_tracks; 0: there are none

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
  /// How many columns the ends before that one lack something in.
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
  /// How many times entries of up to kMostGroupsOfPart groups there are.
  int entry_parts() const {
    constexpr auto kMost = static_cast<std::uint32_t>(mocapress::runtime::kMostGroupsOfPart);
    return static_cast<int>((row_groups + kMost - 1) / kMost);
  }
  const mocapress::runtime::CookedEntries& entries_of(int segment, int entry_part, int band) const {
    return at<mocapress::runtime::CookedEntries>(
        entries)[(segment * entry_parts() + entry_part) * mocapress::runtime::kMostKeptBands +
                 band];
  }
  int turn_frames() const {
    if (loop == mocapress::runtime::LoopKind::None) return 0;
    const bool repeats = loop == mocapress::runtime::LoopKind::Repeats;
    return static_cast<int>(frames) - (repeats ? 1 : 0);
  }
};

namespace mocapress::runtime {

/// By its first bytes alone.
inline bool is_cooked(const mcpr_cooked* clip) {
  return clip != nullptr && std::memcmp(clip->magic, mcpr_cooked::kMagic, sizeof clip->magic) == 0;
}

}  // namespace mocapress::runtime
