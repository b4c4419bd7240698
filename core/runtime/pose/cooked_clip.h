// SPDX-License-Identifier: MIT
// The cooked form of a clip, in which the pose of any instant is a weighted sum of a few rows of
// small numbers. One little-endian block without pointers, the same in memory and on disk:
// SAMPLING.md describes it.
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
inline constexpr int kMostGroupsOfPart = 16;  // so that 7 bits can address a column of a part
inline constexpr int kMostColumns = 4096;     // in a clip
inline constexpr int kDetailWindow = 8;       // rows of a detail band that contribute to an instant
inline constexpr int kFinestWindow = 6;       // the same for the finest band
inline constexpr int kCrumbWindow = 12;       // the same for crumbs (2-bit numbers), of which a
                                              // bundle holds four rows
inline constexpr int kSampleWindow = 6;       // rows of samples that contribute to an instant
inline constexpr int kMostKeptBands = 5;      // detail bands of a part
// Bit fields of an entry, which is added to a band's rows.
inline constexpr int kColumnBits = 7;
inline constexpr int kRowBits = 4;              // row number modulo 16
inline constexpr int kEntriesBeyond = 7;        // entries that may be read after a band's last one
inline constexpr int kSampleBytesBeyond = 4;    // bytes that may be read after the last samples
inline constexpr int kMostLog2RowsOfBlock = 3;  // the blocks that contribute to an instant span at
                                                // most 16 rows

/// Storage of a band's detail rows: 2, 4, 8 or 16 bits per number. Rows are interleaved in bundles,
/// as the instructions that multiply pairs expect them.
enum class RowKind : std::uint8_t { None, Crumbs, Nibbles, Bytes, Words };

/// Rows in a bundle.
constexpr int rows_together(RowKind kind) {
  return kind == RowKind::Crumbs ? 4 : 2;
}

/// Bytes of a bundle for one group.
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

/// Bundles of a band with this many rows, including those that may be read after the last.
constexpr int bundles_of(RowKind kind, int rows) {
  const int even = rows < kDetailWindow ? kDetailWindow : (rows + 1) / 2 * 2;
  return kind == RowKind::Crumbs ? (even + 7) / 4 : even / 2;
}

/// The dense rows of one detail band of one part.
struct CookedBand {
  std::uint32_t rows = 0;  // offset from the clip
  RowKind kind = RowKind::None;
  std::uint8_t padding[3] = {};
};

/// Values to add to a band's dense rows, for up to kMostGroupsOfPart groups of columns. An entry
/// has 16 bits, from the lowest: column, row modulo 16, signed value.
struct CookedEntries {
  std::uint32_t begins = 0;    // offset from the clip: u16 start of each block's entries, u16 end
                               // after the last one's, then the entries
  std::uint16_t blocks = 0;    // 0: no entries
  std::uint8_t log2_rows = 0;  // rows of a block
  std::uint8_t padding = 0;
};

/// Groups of columns with the same storage.
struct CookedPart {
  std::uint16_t first_group = 0;
  std::uint16_t groups = 0;
  std::uint8_t kept_bands = 0;      // number of detail bands kept, the finest; coarser ones become
                                    // samples
  std::uint8_t is_wide = 0;         // 1: samples have 24 bits, steps are floats; 0: samples have 16
  std::uint16_t narrow_groups = 0;  // the first groups, whose samples have four bits less

  /// Bits of a group's samples: also the bytes that a row has of them.
  int sample_bits(int group) const {
    return (is_wide != 0 ? 24 : 16) - (group < narrow_groups ? 4 : 0);
  }
  /// Number of narrow ones among the groups from `first` to `end`.
  int narrow_within(int first, int end) const {
    return std::clamp<int>(narrow_groups, first, end) - first;
  }
  /// Bytes of a row of samples before a group's. For the number of groups: of the whole row.
  std::ptrdiff_t sample_place(int group) const {
    return sample_bits(groups) * group - 4 * (group < narrow_groups ? group : narrow_groups);
  }
};

/// A part's data in one segment.
struct CookedRows {
  // Three arrays with one element per column: offset, scale of samples and step, each the upper
  // half of a float, except for the steps of a wide part: these are floats.
  std::uint32_t scales = 0;
  // Row by row, and group by group: whole numbers with a sign, put_sample() tells how. Samples are
  // offset + number * scale.
  std::uint32_t samples = 0;
  std::uint32_t bands = 0;  // a CookedBand for each kept band, the finest first
  float unit = 0;           // multiplied to all steps
};

/// Size of `scales` for this many columns.
constexpr std::uint64_t scale_bytes(bool is_wide, std::uint64_t columns) {
  return 2 * sizeof(std::uint16_t) * columns +
         (is_wide ? sizeof(float) : sizeof(std::uint16_t)) * columns;
}

/// Extends the upper half of a float to a float.
inline float from_upper_half(std::uint16_t half) {
  return bit_pattern<float>(std::uint32_t{half} << 16);
}

/// Offset of a table, in bytes from `mcpr_cooked::tables`. Clips of a bank may share tables.
struct TableOffset {
  std::uint32_t bytes = 0;
};

/// Constant rotations before and after the axes of a group's joints.
enum class AroundKind : std::uint8_t {
  None,
  // The two are inverses of each other: a 3 x 3 matrix per joint, which maps rotations about the
  // first, second and third axis to x, y and z. Each number is stored for
  // all eight joints before the next.
  Inverses,
  Any,  // the quaternion before, then the one after, w x y z, each number for all eight joints
};

/// Floats in a group's table.
constexpr std::uint64_t floats_around(AroundKind kind) {
  if (kind == AroundKind::None) return 0;
  return (kind == AroundKind::Inverses ? 9 : 8) * std::uint64_t{kGroup};
}

/// Eight joints that rotate about up to three different axes each.
struct RotorGroup {
  std::uint16_t joint[kGroup] = {};  // kNoJoint: none
  std::uint16_t vector[3] = {};      // groups of columns with the first, second and third half
                                     // angles
  std::uint8_t angles = 0;           // 1 to 3: number of vectors in use
  std::uint8_t joints = 0;           // number of joints in `joint`
  std::uint8_t has_angle[3] = {};    // one bit per joint
  std::uint8_t is_odd = 0;           // one bit per joint: its axes are an odd permutation of x y z
  std::uint8_t first_axis[3] = {};   // one bit per joint whose first axis is x, y, z
  std::uint8_t second_axis[3] = {};  // the same for the second axis; the third is the remaining one
  AroundKind around_kind = AroundKind::None;
  std::uint8_t are_near = 0;  // one bit per vector: all its half angles stay within an eighth of a
                              // turn
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

/// A factor of the rotation of a joint in no group: a rotation about one axis, or a constant.
struct OtherTurn {
  std::uint16_t joint = 0;
  std::uint16_t axis = 0;  // 0 1 2: x y z; kConstant: `column` is the TableOffset of a quaternion
  std::uint32_t column = 0;
  static constexpr std::uint16_t kConstant = 3;
};

/// Extrapolation of a column from the last frame of a loop to the first.
enum class ColumnKind : std::uint8_t { Straight, HalfAngle, Root };

}  // namespace mocapress::runtime

struct mcpr_cooked {
  static constexpr char kMagic[4] = {'M', 'C', 'P', 'C'};
  static constexpr std::uint32_t kVersion = 8;
  char magic[4];
  std::uint32_t checksum;  // CRC-32 of `bytes`, and of everything from `version` on
  std::uint64_t bytes;     // size of the clip
  std::int64_t tables;  // base of table offsets, relative to the clip; 0 outside banks. Not part of
                        // the checksum
  std::uint32_t version;
  std::uint32_t skeleton_bytes;  // the part of `bytes` that does not grow with the motion
  double sample_rate;            // frames per second
  std::uint32_t frames;
  std::uint32_t segment_length;
  std::uint32_t segment_overlap;
  std::uint32_t joints;
  std::uint32_t groups;      // groups of columns
  std::uint32_t row_groups;  // the first groups, which have rows; the others copy values
  std::uint16_t parts;
  std::uint16_t segments;
  std::uint16_t rotor_groups;
  std::uint16_t moving_axes;
  std::uint16_t added_columns;
  std::uint16_t other_turns;
  mocapress::runtime::Wavelet wavelet;
  mocapress::runtime::LoopKind loop;
  mocapress::runtime::EndReaches end_reaches;  // as in ENDS of FORMAT.md
  std::uint8_t has_skeleton;  // 1: after the head, u32 bytes of a skeleton item, and the item
  std::uint8_t unused;
  float end_units[mocapress::runtime::kMostEnds];
  mocapress::runtime::TableOffset rest;        // an mcpr_transform per joint: its constant values
  mocapress::runtime::TableOffset rotors;      // RotorGroup array
  mocapress::runtime::TableOffset moving;      // MovingAxis array
  mocapress::runtime::TableOffset added;       // AddedColumn array
  mocapress::runtime::TableOffset turns;       // OtherTurn array
  mocapress::runtime::TableOffset bases;       // floats: initial values of the columns without rows
  mocapress::runtime::TableOffset part_table;  // CookedPart array
  mocapress::runtime::TableOffset column_kinds;  // ColumnKind array; only if the loop's first frame
                                                 // follows the last
  // Offsets from the clip.
  std::uint32_t ends;     // for each end correction: one byte per group of columns, with a bit for
                          // each column that it changes; then for these columns, end after end:
                          // i16, in units of end_units times the step
  std::uint32_t rows;     // CookedRows of each part, segment by segment
  std::uint32_t entries;  // CookedEntries of kMostKeptBands bands, the finest first, for each
                          // kMostGroupsOfPart groups; segment by segment
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
  /// Number of columns that the end corrections 0 ... `end` - 1 change, added up.
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
  /// Number of sets of kMostGroupsOfPart groups; each set of groups has its own entries.
  int entry_parts() const {
    constexpr auto kMost = static_cast<std::uint32_t>(mocapress::runtime::kMostGroupsOfPart);
    return static_cast<int>((row_groups + kMost - 1) / kMost);
  }
  const mocapress::runtime::CookedEntries& entries_of(int segment, int entry_part, int band) const {
    return at<mocapress::runtime::CookedEntries>(
        entries)[(segment * entry_parts() + entry_part) * mocapress::runtime::kMostKeptBands +
                 band];
  }
  /// Names and parents; no joints if they were not kept.
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

/// True if this is a cooked clip, judging by its first bytes.
inline bool is_cooked(const mcpr_cooked* clip) {
  return clip != nullptr && std::memcmp(clip->magic, mcpr_cooked::kMagic, sizeof clip->magic) == 0;
}

}  // namespace mocapress::runtime
