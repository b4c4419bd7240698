// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_check.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/runtime/decode/track_block.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/memory.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {
namespace {

/// Checks tables and rows, one after the other. `sound_` turns false at the first failure.
class Checker {
 public:
  Checker(const mcpr_cooked& clip, const TableRange& tables)
      : clip_(clip),
        tables_(tables),
        columns_(static_cast<std::uint32_t>(kGroup) * clip.groups),
        row_columns_(static_cast<std::uint32_t>(kGroup) * clip.row_groups) {}

  bool run() {
    require(clip_.tables == tables_.from);
    require(clip_.wavelet <= Wavelet::Cubic && clip_.loop <= LoopKind::Follows);
    require(clip_.groups <= kMostColumns / kGroup && clip_.row_groups <= clip_.groups);
    require(clip_.joints >= 1 && clip_.joints <= kMostJoints);
    require(clip_.frames >= 1 && clip_.frames <= kMostFrames);
    require(std::isfinite(clip_.sample_rate) && clip_.sample_rate > 0);
    require(clip_.loop != LoopKind::Repeats || clip_.frames >= 2);
    if (!sound_) return false;
    const bool whole = clip_.segment_length == clip_.frames && clip_.segment_overlap == 0;
    require(whole || may_be_segments(clip_.frames, clip_.segment_length, clip_.segment_overlap));
    require(sound_ && clip_.segments == clip_.layout().count());
    require_array(clip_.rest, sizeof(mcpr_transform), clip_.joints, kAlignment);
    if (clip_.groups > clip_.row_groups)
      require_array(clip_.bases, sizeof(float), columns_ - row_columns_, 4);
    require(clip_.rotor_groups <= kMostJoints / kGroup);
    check_joints();
    if (clip_.loop == LoopKind::Follows) require_array(clip_.column_kinds, 1, row_columns_, 1);
    const EndReaches& reaches = clip_.end_reaches;
    require(reaches.any() == (reaches.frames[kLastPose] > 0));
    require(reaches.any() || reaches.frames[kVelocity] == 0);
    if (reaches.any()) check_ends();
    check_parts();
    if (clip_.tracks != 0) check_tracks();
    if (clip_.has_skeleton != 0) check_skeleton();
    return sound_;
  }

 private:
  void require(bool holds) { sound_ = sound_ && holds; }
  void require_array(std::uint32_t offset, std::uint64_t size, std::uint64_t count,
                     std::uint32_t alignment) {
    require(offset >= sizeof(mcpr_cooked) && offset % alignment == 0 &&
            offset + size * count <= clip_.bytes);
  }
  void require_array(TableOffset offset, std::uint64_t size, std::uint64_t count,
                     std::uint32_t alignment) {
    require(offset.bytes >= tables_.first && offset.bytes % alignment == 0 &&
            offset.bytes + size * count <= tables_.end);
  }
  /// Checks that a table lies within its range, then checks all elements.
  template <typename T, typename Check>
  void each(TableOffset offset, std::uint32_t count, const Check& check) {
    require_array(offset, sizeof(T), count, alignof(T));
    for (std::uint32_t i = 0; i < count && sound_; ++i) check(clip_.at<T>(offset)[i]);
  }

  void check_ends() {
    require_array(clip_.ends, clip_.end_reaches.count(), clip_.row_groups, 1);
    if (!sound_) return;
    require_array(clip_.end_values(), sizeof(std::int16_t),
                  clip_.lacking_before(static_cast<int>(clip_.end_reaches.count())), 2);
  }

  void check_joints() {
    each<RotorGroup>(clip_.rotors, clip_.rotor_groups, [&](const RotorGroup& group) {
      require(group.angles >= 1 && group.angles <= 3 && group.joints <= kGroup);
      for (int a = 0; a < group.angles && a < 3; ++a) require(group.vector[a] < clip_.groups);
      for (int i = 0; i < group.joints && i < kGroup; ++i) require(group.joint[i] < clip_.joints);
      require(group.around_kind <= AroundKind::Any && group.are_near < 8);
      if (sound_ && group.around_kind != AroundKind::None)
        require_array(group.around, sizeof(float), floats_around(group.around_kind), 4);
    });
    each<MovingAxis>(clip_.moving, clip_.moving_axes, [&](const MovingAxis& moving) {
      require(moving.joint < clip_.joints && moving.axis < 3 && moving.column < columns_);
    });
    each<AddedColumn>(clip_.added, clip_.added_columns, [&](const AddedColumn& added) {
      require(added.from < columns_ && added.to < columns_);
    });
    each<OtherTurn>(clip_.turns, clip_.other_turns, [&](const OtherTurn& turn) {
      require(turn.joint < clip_.joints && turn.axis <= OtherTurn::kConstant);
      if (turn.axis == OtherTurn::kConstant)
        require_array(TableOffset{turn.column}, sizeof(float), 4, 4);
      else
        require(turn.column < columns_);
    });
  }

  void check_parts() {
    std::uint32_t groups = 0;
    each<CookedPart>(clip_.part_table, clip_.parts, [&](const CookedPart& part) {
      require(part.first_group == groups && part.groups >= 1 && part.groups <= kMostGroupsOfPart);
      require(part.kept_bands <= kMostKeptBands && part.is_wide <= 1 &&
              part.narrow_groups <= part.groups);
      groups += part.groups;
    });
    require(groups == clip_.row_groups);
    require_array(clip_.rows, sizeof(CookedRows), std::uint64_t{clip_.parts} * clip_.segments, 4);
    require_array(clip_.entries, sizeof(CookedEntries),
                  std::uint64_t{kMostKeptBands} * static_cast<std::uint64_t>(clip_.entry_parts()) *
                      clip_.segments,
                  4);
    for (int k = 0; k < clip_.segments && sound_; ++k) {
      for (int p = 0; p < clip_.parts && sound_; ++p)
        check_rows(clip_.part(p), clip_.rows_of(k, p), clip_.layout().frames_of(k));
      for (int e = 0; e < clip_.entry_parts(); ++e)
        for (int b = 0; b < kMostKeptBands && sound_; ++b)
          check_entries(clip_.entries_of(k, e, b), row_columns_ - kGroup * kMostGroupsOfPart * e);
    }
  }

  void check_tracks() {
    require_array(clip_.tracks, sizeof(mcpr_tracks), 1, 8);
    if (!sound_) return;
    const auto& tracks = *clip_.at<mcpr_tracks>(clip_.tracks);
    require(tracks.frames == clip_.frames && tracks.loop == clip_.loop &&
            are_sound(tracks, clip_.bytes - clip_.tracks));
  }

  void check_skeleton() {
    const std::uint64_t room = clip_.bytes - sizeof clip_;
    std::uint32_t size = 0;
    require(clip_.has_skeleton == 1 && room >= sizeof size);
    if (!sound_) return;
    std::memcpy(&size, &clip_ + 1, sizeof size);
    require(size <= room - sizeof size);
    require(sound_ && clip_.skeleton().is_sound() && clip_.skeleton().joints() == clip_.joints);
  }

  void check_rows(const CookedPart& part, const CookedRows& rows, int frames) {
    const Bands bands(frames);
    const std::uint64_t columns = std::uint64_t{kGroup} * part.groups;
    const int kept = std::min<int>(part.kept_bands, bands.count - 1);
    const int samples = std::max(bands.length(bands.count - 1 - kept), kSampleWindow);
    require_array(rows.scales, 1, scale_bytes(part.is_wide != 0, columns), 4);
    require_array(
        rows.samples, 1,
        static_cast<std::uint64_t>(part.sample_place(part.groups) * samples) + kSampleBytesBeyond,
        2);
    require_array(rows.bands, sizeof(CookedBand), part.kept_bands, alignof(CookedBand));
    for (int depth = 1; depth <= kept && sound_; ++depth)
      check_band(part, clip_.at<CookedBand>(rows.bands)[depth - 1],
                 bands[bands.count - depth].size);
  }

  void check_band(const CookedPart& part, const CookedBand& band, int rows) {
    require(band.kind <= RowKind::Words);
    if (sound_ && band.kind != RowKind::None)
      require_array(band.rows, bundle_bytes(band.kind) * part.groups,
                    static_cast<std::uint64_t>(bundles_of(band.kind, rows)), 1);
  }

  /// Checks a set of entries. Their columns must be below `columns`.
  void check_entries(const CookedEntries& entries, std::uint32_t columns) {
    if (entries.blocks == 0) return;
    require(entries.log2_rows <= kMostLog2RowsOfBlock);
    require_array(entries.begins, 2, entries.blocks + 1U, 2);
    if (!sound_) return;
    const auto* const begins = clip_.at<std::uint16_t>(entries.begins);
    const std::uint16_t count = begins[entries.blocks];
    require(begins[0] == 0 && std::is_sorted(begins, begins + entries.blocks + 1));
    require_array(entries.begins, 2, entries.blocks + 1U + count + kEntriesBeyond, 2);
    for (int i = 0; i < count && sound_; ++i)
      require((begins[entries.blocks + 1 + i] & ((1U << kColumnBits) - 1)) < columns);
  }

  const mcpr_cooked& clip_;
  const TableRange tables_;
  const std::uint32_t columns_;
  const std::uint32_t row_columns_;  // number of columns that have rows
  bool sound_ = true;
};

}  // namespace

std::uint32_t checksum_of(const mcpr_cooked& clip) {
  constexpr std::size_t kHead = offsetof(mcpr_cooked, version);
  std::uint8_t bytes[8];
  std::memcpy(bytes, &clip.bytes, sizeof bytes);
  return section_checksum(bytes, reinterpret_cast<const std::uint8_t*>(&clip) + kHead,
                          static_cast<std::size_t>(clip.bytes) - kHead);
}

mcpr_result check_cooked_head(const mcpr_cooked& clip, std::size_t size) {
  if (std::memcmp(clip.magic, mcpr_cooked::kMagic, sizeof clip.magic) != 0)
    return failure(MCPR_NOT_A_CLIP, 0, "no cooked clip");
  if (clip.version != mcpr_cooked::kVersion)
    return failure(MCPR_UNKNOWN_VERSION, offsetof(mcpr_cooked, version),
                   "a cooked clip of another version: cook it again");
  if (clip.bytes < sizeof(mcpr_cooked) || clip.bytes > size)
    return failure(MCPR_DAMAGED, offsetof(mcpr_cooked, bytes), "the cooked clip is cut short");
  return kOk;
}

mcpr_result check_cooked(const mcpr_cooked& clip, const TableRange& tables) {
  if (checksum_of(clip) != clip.checksum)
    return failure(MCPR_DAMAGED, offsetof(mcpr_cooked, checksum),
                   "the cooked clip's checksum differs");
  if (!Checker(clip, tables).run()) return failure(MCPR_INVALID, 0, "an impossible cooked clip");
  return kOk;
}

}  // namespace mocapress::runtime
