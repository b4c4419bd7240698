// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_columns.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace mocapress::runtime {

CookedColumns::CookedColumns(Memory& memory, const ClipBlock& clip,
                             CookedCoefficients& coefficients, BandRange bands)
    : clip_(clip), coefficients_(coefficients), bands_(bands), wide_bands_(bands.fewest) {
  const auto channels = std::uint64_t{clip_.channel_count};
  channels_ = memory.take<Channel>(channels);
  rotors_ = memory.take<Rotor>(clip_.joint_count);
  vectors_ = reinterpret_cast<int(*)[3]>(
      memory.take<int>(3 * (std::uint64_t{clip_.joint_count} / kGroup + 1)));
  columns_ = memory.take<Column>(kMostColumns);
  moving_ = memory.take<MovingAxis>(channels);
  added_ = memory.take<AddedColumn>(channels);
  turns_ = memory.take<Turn>(channels + 2 * std::uint64_t{clip_.joint_count});
}

mcpr_result CookedColumns::place() {
  std::fill_n(channels_, clip_.channel_count, Channel{});
  std::fill_n(columns_, kMostColumns, Column{});
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) {
    const JointModel& joint = clip_.joint_models()[j];
    for (int c = 0; c < joint.channels; ++c) {
      Channel& channel = channels_[joint.first_channel + c];
      channel.joint = static_cast<std::uint16_t>(j);
      channel.kind = joint.kinds[c];
      channel.factor = is_rotation(joint.kinds[c]) ? 0.5 : 1;
      channel.is_wide = channel.changes = coefficients_.is_fine(joint.first_channel + c);
      channel.least = std::numeric_limits<double>::max();
      channel.most = std::numeric_limits<double>::lowest();
      for (int end = 0; end < kMostEnds && clip_.end_reaches.frames[end] > 0; ++end)
        channel.changes |= coefficients_.end_value(end, joint.first_channel + c) != 0;
    }
  }
  for (int k = 0; k < clip_.segments.count(); ++k) analyse_segment(k);
  for (int c = 0; c < channel_count(); ++c)
    for (int end = 0; end < kMostEnds && clip_.end_reaches.frames[end] > 0; ++end)
      channels_[c].furthest += largest_end_share(end, clip_.end_reaches.frames[end]) *
                               std::abs(static_cast<double>(coefficients_.end_value(end, c)));
  choose_wide();
  return place_columns();
}

void CookedColumns::analyse_segment(int segment) {
  coefficients_.load(segment);
  const Bands& bands = coefficients_.bands();
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    const std::span<double> samples = coefficients_.samples_of(c, bands_.fewest);
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
    channel.least = std::min(channel.least, *least);
    channel.most = std::max(channel.most, *most);
    if (is_rotation(channel.kind)) see_angles(c, segment);
    for (int depth = 1; depth <= kMostKeptBands && depth < bands.count; ++depth) {
      const int band = bands.count - depth;
      std::int32_t largest = 0;
      for (int i = 0; i < bands[band].size; ++i)
        largest = std::max(largest, std::abs(coefficients_.value(c, band, i)));
      channel.largest[depth - 1] = std::max(channel.largest[depth - 1], largest);
      const double unit = is_rotation(channel.kind) ? 0.25 : 1;
      channel.reach[depth - 1] =
          std::max(channel.reach[depth - 1],
                   coefficients_.step(c) / unit * power_of_root_two(-bands.depth(band)) * largest);
    }
  }
}

/// Updates the largest magnitude of an angle with the frames of a segment. It includes the end of
/// the step from the last frame of a loop to the next cycle, where a root repeats its last step.
void CookedColumns::see_angles(int c, int segment) {
  Channel& channel = channels_[c];
  const std::span<const double> angles = coefficients_.samples_of(c, 0);
  const auto see = [&](double angle) {
    channel.furthest = std::max(channel.furthest, std::abs(angle));
  };
  for (const double angle : angles) see(angle);
  if (clip_.loop == LoopKind::Follows && segment + 1 == clip_.segments.count() && angles.size() > 1)
    see(2 * angles.back() - angles[angles.size() - 2]);
}

/// True if half of an angle stays within the range of near_sine_and_cosine(), with a margin for
/// rounding to 16 bits.
bool CookedColumns::is_near(const Channel& channel) const {
  constexpr double kEighth = 0.785398163;  // radians
  constexpr double kRoom = 2e-3;
  const double furthest = channel.changes ? channel.furthest : std::abs(channel.constant);
  return channel.factor * furthest < kEighth - kRoom;
}

/// Marks the channels as wide whose range is too large for 16-bit samples, or whose details are too
/// large for integer weights. Bands with such details become samples.
void CookedColumns::choose_wide() {
  constexpr double kStill = 1e-7;  // cm or radians
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    bool has_details = false;
    int kept = bands_.most;  // number of the finest bands with small enough details
    for (int b = kMostKeptBands - 1; b >= 0; --b) {
      has_details |= channel.largest[b] != 0;
      if (b < kept && (channel.largest[b] > kMostValue || channel.reach[b] > kMostReach)) kept = b;
    }
    channel.changes |= has_details || channel.most - channel.least > kStill;
    channel.constant = 0.5 * (channel.least + channel.most);
    channel.is_wide |=
        channel.changes && (channel.most - channel.least > kMostRange || kept < bands_.most);
    if (channel.is_wide) wide_bands_ = std::min(wide_bands_, kept);
  }
}

/// Fills the last group of wide columns with more channels: of those without a column, the ones
/// with the largest details.
void CookedColumns::fill_wide() {
  int wide = 0;
  for (int c = 0; c < channel_count(); ++c) wide += channels_[c].is_wide ? 1 : 0;
  const auto size_of = [this](const Channel& channel) {
    return *std::max_element(channel.largest, channel.largest + bands_.most);
  };
  for (; wide % kGroup != 0; ++wide) {
    Channel* largest = nullptr;
    for (int c = 0; c < channel_count(); ++c) {
      Channel& channel = channels_[c];
      if (!channel.is_wide && channel.changes && channel.column < 0 &&
          (largest == nullptr || size_of(channel) > size_of(*largest)))
        largest = &channel;
    }
    if (largest == nullptr) return;
    largest->is_wide = true;
  }
}

int CookedColumns::new_group() {
  if (kGroup * (groups_ + 1) > kMostColumns) return -1;
  for (int i = 0; i < kGroup; ++i) columns_[kGroup * groups_ + i] = {.is_free = true};
  return groups_++;
}

/// Finds a free column for a channel, or starts a new group. Wide channels go to the groups after
/// the normal ones. Returns -1 if there is no room.
std::int32_t CookedColumns::place(int channel) {
  std::int32_t column = channels_[channel].is_wide ? kGroup * normal_groups_ : 0;
  while (column < kGroup * groups_ && !columns_[column].is_free) ++column;
  if (column == kGroup * groups_ && new_group() < 0) return -1;
  columns_[column] = {.channel = channel, .factor = channels_[channel].factor};
  return column;
}

/// Decides how a joint is rotated: as a rotor, by other turns, or not at all.
void CookedColumns::place_joint(int j) {
  const JointModel& joint = clip_.joint_models()[j];
  Rotor rotor{.joint = static_cast<std::uint16_t>(j)};
  int turning = 0;
  bool changes = false;
  unsigned axes = 0;
  bool repeats = false;
  for (int c = 0; c < joint.channels; ++c) {
    const int number = joint.first_channel + c;
    const Channel& channel = channels_[number];
    if (!is_rotation(channel.kind) || (!channel.changes && channel.constant == 0)) continue;
    changes |= channel.changes;
    const unsigned axis = 1U << axis_of(channel.kind);
    repeats |= (axes & axis) != 0;
    axes |= axis;
    if (turning < 3) {
      rotor.channel[turning] = static_cast<std::uint16_t>(number);
      if (!is_near(channel)) rotor.are_near &= static_cast<std::uint8_t>(~(1U << turning));
    }
    ++turning;
  }
  if (!changes) return;
  if (!repeats) {
    rotor.angles = static_cast<std::uint8_t>(turning);
    rotors_[rotor_count_++] = rotor;
    return;
  }
  const auto number = static_cast<std::uint16_t>(j);
  const auto add = [&](int axis, int channel, bool after) {
    turns_[turn_count_++] = {{number, static_cast<std::uint16_t>(axis), 0}, channel, after};
  };
  if (joint.has_axes) add(OtherTurn::kConstant, -1, false);
  for (int c = 0; c < joint.channels; ++c)
    if (is_rotation(joint.kinds[c])) {
      channels_[joint.first_channel + c].changes = true;  // gives it a column
      add(axis_of(joint.kinds[c]), joint.first_channel + c, false);
    }
  if (joint.has_axes) add(OtherTurn::kConstant, -1, true);
}

/// Places angles at the columns where a rotor group reads them, for vectors that are more than half
/// full.
bool CookedColumns::place_full_vectors() {
  for (int first = 0; first < rotor_count_; first += kGroup)
    for (int a = 0; a < 3; ++a) {
      const int joints = std::min(kGroup, rotor_count_ - first);
      const auto has_own = [&](int i) {
        const Rotor& rotor = rotors_[first + i];
        return i < joints && a < rotor.angles && channels_[rotor.channel[a]].changes &&
               !channels_[rotor.channel[a]].is_wide;
      };
      int own = 0;
      for (int i = 0; i < kGroup; ++i) own += has_own(i) ? 1 : 0;
      int& group = vectors_[first / kGroup][a];
      group = -1;
      if (own <= kGroup / 2) continue;
      if ((group = new_group()) < 0) return false;
      for (int i = 0; i < joints; ++i) {
        const Rotor& rotor = rotors_[first + i];
        if (a >= rotor.angles) continue;
        const Channel& channel = channels_[rotor.channel[a]];
        columns_[kGroup * group + i] = {
            .channel = has_own(i) ? rotor.channel[a] : -1,
            .base = channel.changes ? 0 : channel.constant * channel.factor,
            .factor = channel.factor};
      }
    }
  return true;
}

/// Gives a column to each channel that changes and has none yet: to the wide channels, or to the
/// others.
bool CookedColumns::place_others(bool wide) {
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    if (!channel.changes || channel.is_wide != wide) continue;
    if (channel.column < 0) channel.column = place(c);
    if (channel.column < 0) return false;
  }
  return true;
}

/// True if the samples of a group can do with four bits less.
bool CookedColumns::is_narrow(int group, bool wide) const {
  const double steps = wide ? 0x1p20 : 0x1p12;
  return std::all_of(&columns_[kGroup * group], &columns_[kGroup * (group + 1)],
                     [&](const Column& column) {
                       if (column.channel < 0) return true;
                       const Channel& channel = channels_[column.channel];
                       return column.factor * (channel.most - channel.least) <
                              steps * (is_rotation(channel.kind) ? kMostTurn : kMostShift);
                     });
}

/// Divides consecutive groups into parts. Moves the narrow groups of each part to its start.
void CookedColumns::add_parts(int first, int end, bool wide) {
  for (; first < end; first += kMostGroupsOfPart) {
    CookedPart& part = parts_[part_count_++];
    part = {.first_group = static_cast<std::uint16_t>(first),
            .groups = static_cast<std::uint16_t>(std::min(end - first, kMostGroupsOfPart)),
            .kept_bands = static_cast<std::uint8_t>(wide ? wide_bands_ : bands_.most),
            .is_wide = static_cast<std::uint8_t>(wide ? 1 : 0)};
    for (int group = first; group < first + part.groups; ++group) {
      if (!is_narrow(group, wide)) continue;
      const int place = first + part.narrow_groups++;
      std::swap_ranges(&columns_[kGroup * group], &columns_[kGroup * (group + 1)],
                       &columns_[kGroup * place]);
      for (int v = 0; v < 3 * ((rotor_count_ + kGroup - 1) / kGroup); ++v) {
        int& vector = vectors_[v / 3][v % 3];
        if (vector == group)
          vector = place;
        else if (vector == place)
          vector = group;
      }
    }
  }
}

/// Adds groups of columns that have no rows. Rotors read them; their values are copied from other
/// columns.
bool CookedColumns::place_gathered_vectors() {
  for (int first = 0; first < rotor_count_; first += kGroup)
    for (int a = 0; a < rotors_[first].angles; ++a) {
      int& group = vectors_[first / kGroup][a];
      const bool is_new = group < 0;
      if (is_new && (group = new_group()) < 0) return false;
      for (int i = 0; i < kGroup && first + i < rotor_count_; ++i) {
        const Rotor& rotor = rotors_[first + i];
        if (a >= rotor.angles) continue;
        const Channel& channel = channels_[rotor.channel[a]];
        const int column = kGroup * group + i;
        if (is_new && !channel.changes) columns_[column].base = channel.constant * channel.factor;
        if (channel.changes && channel.column != column)
          added_[added_count_++] = {static_cast<std::uint16_t>(channel.column),
                                    static_cast<std::uint16_t>(column)};
      }
    }
  return true;
}

mcpr_result CookedColumns::place_columns() {
  const auto too_many = failure(MCPR_LIMIT, 0, "more channels than a cooked clip can have");
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) place_joint(static_cast<int>(j));
  // Sorts by number of angles. Among joints with the same number, those with half angles beyond an
  // eighth of a turn come first; with two angles, they come last.
  std::sort(rotors_, rotors_ + rotor_count_, [](const Rotor& a, const Rotor& b) {
    if (a.angles != b.angles) return a.angles > b.angles;
    if (a.are_near != b.are_near) {
      const bool is_further = a.far() != b.far() ? a.far() > b.far() : a.are_near < b.are_near;
      return is_further == (a.angles != 2);
    }
    return a.joint < b.joint;
  });
  if (!place_full_vectors()) return too_many;
  note_columns();
  fill_wide();
  if (!place_others(false)) return too_many;
  normal_groups_ = groups_;
  if (!place_others(true)) return too_many;
  row_groups_ = groups_;
  add_parts(0, normal_groups_, false);
  add_parts(normal_groups_, row_groups_, true);
  note_columns();
  list_moving();
  if (!place_gathered_vectors()) return too_many;
  place_offsets();
  return kOk;
}

/// Sets `column` of each channel that has a column.
void CookedColumns::note_columns() {
  for (int k = 0; k < kGroup * groups_; ++k)
    if (columns_[k].channel >= 0) channels_[columns_[k].channel].column = k;
}

void CookedColumns::list_moving() {
  for (int c = 0; c < channel_count(); ++c) {
    const Channel& channel = channels_[c];
    if (channel.changes && !is_rotation(channel.kind))
      moving_[moving_count_++] = {channel.joint, static_cast<std::uint16_t>(axis_of(channel.kind)),
                                  static_cast<std::uint32_t>(channel.column)};
  }
}

/// Adds the constant part of a translation to the first column that moves the joint along that
/// axis.
void CookedColumns::place_offsets() {
  for (int m = 0; m < moving_count_; ++m) {
    const JointModel& joint = clip_.joint_models()[moving_[m].joint];
    double base = joint.offset[moving_[m].axis];
    for (int c = 0; c < joint.channels; ++c) {
      const Channel& channel = channels_[joint.first_channel + c];
      if (!channel.changes && channel.kind == moving_[m].axis) base += channel.constant;
    }
    columns_[moving_[m].column].base = base;
  }
}

void CookedColumns::keep_bands(int bands) {
  for (int p = 0; p < part_count_; ++p)
    if (parts_[p].is_wide == 0) parts_[p].kept_bands = static_cast<std::uint8_t>(bands);
}

}  // namespace mocapress::runtime
