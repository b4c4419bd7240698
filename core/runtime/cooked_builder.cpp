// SPDX-License-Identifier: MIT
#include "core/runtime/cooked_builder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>

#include "core/codec/format/end_poses.h"
#include "core/runtime/cooked_check.h"
#include "core/runtime/frame_decoder.h"
#include "core/runtime/lifting_line.h"

namespace mocapress::runtime {
namespace {

constexpr int kRowsAtATime = 128;
constexpr std::uint64_t kMostPerBlock = 20;    // at most on average, if a block has several rows
constexpr std::uint64_t kMostEntries = 65535;  // of a band: where a block begins is 16 bits

struct Limits {
  std::int32_t least;
  std::int32_t most;
};

constexpr Limits limits_of(RowKind kind) {
  switch (kind) {
    case RowKind::None:
      return {0, 0};
    case RowKind::Crumbs:
      return {-2, 1};
    case RowKind::Nibbles:
      return {-8, 7};
    case RowKind::Bytes:
      return {-128, 127};
    case RowKind::Words:
      break;
  }
  return {-32768, 32767};
}

/// What dense rows of a kind leave to entries.
constexpr std::int32_t left_by(RowKind kind, std::int32_t value) {
  const Limits limits = limits_of(kind);
  return value - std::clamp(value, limits.least, limits.most);
}

constexpr std::int32_t kLeastOfEntry = -(1 << (15 - kColumnBits - kRowBits));
constexpr std::int32_t kMostOfEntry = -kLeastOfEntry - 1;

/// Entries whose values come to this.
constexpr std::uint64_t entries_for(std::int32_t value) {
  return static_cast<std::uint64_t>(value < 0 ? (value + kLeastOfEntry + 1) / kLeastOfEntry
                                              : (value + kMostOfEntry - 1) / kMostOfEntry);
}

struct Quaternion {
  double wxyz[4] = {1, 0, 0, 0};
};

Quaternion quaternion_from(const Matrix3& rotation) {
  Quaternion q;
  quaternion_of(rotation, q.wxyz);
  return q;
}

}  // namespace

/// Reserves bytes at the end of the clip; without memory only counts them.
class CookedBuilder::Block {
 public:
  explicit Block(std::byte* memory) : memory_(memory) {}

  std::uint32_t reserve(std::uint64_t bytes, std::uint64_t alignment = 4) {
    used_ = (used_ + alignment - 1) / alignment * alignment;
    const std::uint64_t at = used_;
    used_ += bytes;
    return static_cast<std::uint32_t>(
        std::min<std::uint64_t>(at, std::numeric_limits<std::uint32_t>::max()));
  }
  /// Null when measuring.
  template <typename T>
  T* reserve_for(std::uint64_t count, std::uint32_t& offset, std::uint64_t alignment = alignof(T)) {
    offset = reserve(sizeof(T) * count, alignment);
    return memory_ != nullptr ? reinterpret_cast<T*>(memory_ + offset) : nullptr;
  }
  std::byte* at(std::uint32_t offset) const {
    return memory_ != nullptr ? memory_ + offset : nullptr;
  }
  std::uint64_t used() const { return used_; }
  void round_up(std::uint64_t alignment) {
    used_ = (used_ + alignment - 1) / alignment * alignment;
  }

 private:
  std::byte* memory_;
  std::uint64_t used_ = 0;
};

CookedBuilder::CookedBuilder(Memory& memory, const mcpr_clip& clip, bool apply_ik)
    : clip_(clip.block), apply_ik_(apply_ik && clip.block.effector_count > 0) {
  const auto channels = std::uint64_t{clip_.channel_count};
  const auto frames = static_cast<std::uint64_t>(clip_.largest.length);
  const auto signals = static_cast<std::uint64_t>((clip_.largest.signal_count + 7) / 8 * 8);
  channels_ = memory.take<Channel>(channels);
  rotors_ = memory.take<Rotor>(clip_.joint_count);
  vectors_ = reinterpret_cast<int(*)[3]>(
      memory.take<int>(3 * (std::uint64_t{clip_.joint_count} / kGroup + 1)));
  columns_ = memory.take<Column>(kMostColumns);
  moving_ = memory.take<MovingAxis>(channels);
  added_ = memory.take<AddedColumn>(channels);
  turns_ = memory.take<Turn>(channels + 2 * std::uint64_t{clip_.joint_count});
  values_ = memory.take<std::int32_t>(channels * frames);
  steps_ = memory.take<double>(channels);
  rows_ = memory.take<double>(signals * kRowsAtATime);
  in_order_ = memory.take<std::int32_t>(signals);
  line_ = memory.take<double>(frames);
  other_line_ = memory.take<double>(frames);
  samples_ = memory.take<double>(frames);
  if (!apply_ik_) return;
  corrected_ = memory.take<float>(channels * static_cast<std::uint64_t>(clip_.segments.frames));
  mcpr_request request{};
  request.apply_ik = 1;
  Memory measured;
  const FrameDecoder decoder(measured, clip_, request);
  decoding_bytes_ = measured.used();
  decoding_ = memory.take<std::byte>(decoding_bytes_);
}

/// Frames with the correction but without what the ends lack, which is added at every instant.
void CookedBuilder::decode_corrected() {
  mcpr_request request{};
  request.apply_ik = 1;
  Memory memory(decoding_, decoding_bytes_);
  const int frames = clip_.segments.frames;
  FrameDecoder(memory, clip_, request).decode(0, frames, corrected_);
  for (int end = 0; end < 2; ++end) {
    const int reach = std::min<int>(clip_.end_reach[end], frames);
    for (int away = 0; away < reach; ++away) {
      float* const row = corrected_ + std::ptrdiff_t{end == 0 ? away : frames - 1 - away} *
                                          static_cast<std::ptrdiff_t>(clip_.channel_count);
      for (int c = 0; c < channel_count(); ++c)
        row[c] -= end_share(away, reach) * clip_.end_values(end)[c];
    }
  }
}

mcpr_result CookedBuilder::prepare() {
  std::fill_n(channels_, clip_.channel_count, Channel{});
  std::fill_n(columns_, kMostColumns, Column{});
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) {
    const JointModel& joint = clip_.joint_models()[j];
    for (int c = 0; c < joint.channels; ++c) {
      Channel& channel = channels_[joint.first_channel + c];
      channel.joint = static_cast<std::uint16_t>(j);
      channel.kind = joint.kinds[c];
      channel.factor = is_rotation(joint.kinds[c]) ? 0.5 : 1;
      channel.least = std::numeric_limits<double>::max();
      channel.most = std::numeric_limits<double>::lowest();
      for (int end = 0; end < 2 && clip_.end_reach[0] > 0; ++end)
        channel.changes |= clip_.end_values(end)[joint.first_channel + c] != 0;
    }
  }
  if (apply_ik_) {
    decode_corrected();
    for (int l = 0; l < clip_.limb_count; ++l)
      for (int a = 0; a < clip_.limb(l).turns; ++a) {
        Channel& channel = channels_[clip_.limb(l).turn[a].channel];
        channel.is_corrected = channel.is_wide = channel.changes = true;
      }
  }
  for (int k = 0; k < clip_.segments.count(); ++k) analyse_segment(k);
  choose_wide();
  return place_columns();
}

/// The coefficients as whole numbers again: what was unpacked of one step is far from half another.
void CookedBuilder::load(int segment) {
  if (loaded_ == segment) return;
  loaded_ = segment;
  const ResidentSignals& motion = clip_.motion(segment);
  bands_ = Bands(motion.length());
  const std::ptrdiff_t stride = (motion.signal_count() + 7) / 8 * 8;
  for (int s = 0; s < motion.signal_count(); ++s)
    in_order_[s] = s < channel_count() ? s : ResidentSignals::Columns::kNone;
  const ResidentSignals::Columns columns{in_order_, false, stride, nullptr};
  for (int s = 0; s < channel_count(); ++s) steps_[s] = static_cast<double>(motion.step(s));
  std::fill_n(values_, std::ptrdiff_t{channel_count()} * bands_.length(bands_.count - 1), 0);
  for (int b = 0; b < bands_.count; ++b) {
    if (motion.is_empty(b)) continue;
    const double gain = std::exp2(-0.5 * bands_.depth(b));
    for (int first = 0; first < bands_[b].size; first += kRowsAtATime) {
      const int end = std::min(first + kRowsAtATime, bands_[b].size);
      motion.unpack(b, first, end, columns, rows_);
      for (int s = 0; s < channel_count(); ++s)
        for (int i = first; i < end; ++i)
          values_[std::ptrdiff_t{s} * motion.length() + bands_[b].first + i] =
              static_cast<std::int32_t>(
                  std::lround(rows_[(i - first) * stride + s] / (steps_[s] * gain)));
    }
  }
  for (int s = 0; s < channel_count(); ++s)
    if (channels_[s].is_corrected) fit_corrected(s, segment);
}

/// Transforms a corrected channel anew.
void CookedBuilder::fit_corrected(int channel, int segment) {
  const int length = clip_.segments.frames_of(segment);
  const float* from = corrected_ +
                      static_cast<std::ptrdiff_t>(clip_.segments.first(segment)) * channel_count() +
                      channel;
  for (int i = 0; i < length; ++i, from += channel_count()) line_[i] = static_cast<double>(*from);
  steps_[channel] = kFineStep;
  std::int32_t* const values = values_ + std::ptrdiff_t{channel} * length;
  double* fine = line_;
  double* coarse = other_line_;
  for (int b = bands_.count - 1; b > 0; --b) {
    const int rest = bands_.length(b);
    split_line(clip_.motion(segment).wavelet(), rest, fine, coarse, samples_);
    const double gain = std::exp2(-0.5 * bands_.depth(b));
    for (int i = 0; i < bands_[b].size; ++i)
      values[bands_[b].first + i] =
          static_cast<std::int32_t>(std::lround(samples_[i] / (kFineStep * gain)));
    std::swap(fine, coarse);
  }
  const double gain = std::exp2(-0.5 * bands_.depth(0));
  for (int i = 0; i < bands_[0].size; ++i)
    values[i] = static_cast<std::int32_t>(std::lround(fine[i] / (kFineStep * gain)));
}

/// The samples that are left when so many of the finest bands are.
void CookedBuilder::find_samples(int channel, int left_out, double* out) const {
  const int length = bands_.length(bands_.count - 1);
  const std::int32_t* const values = values_ + std::ptrdiff_t{channel} * length;
  const auto unpack = [&](int b, double* to) {
    const double step = steps_[channel] * std::exp2(-0.5 * bands_.depth(b));
    for (int i = 0; i < bands_[b].size; ++i) to[i] = step * values[bands_[b].first + i];
  };
  const int count = std::max(bands_.count - left_out, 1);
  unpack(0, out);
  for (int b = 1; b < count; ++b) {
    unpack(b, other_line_);
    join_line(clip_.motion(loaded_).wavelet(), bands_.length(b), out, other_line_, line_);
    std::copy_n(line_, bands_.length(b), out);
  }
}

void CookedBuilder::analyse_segment(int segment) {
  load(segment);
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    find_samples(c, kFewestBands, samples_);
    const int samples = bands_.length(std::max(bands_.count - 1 - kFewestBands, 0));
    const auto [least, most] = std::minmax_element(samples_, samples_ + samples);
    channel.least = std::min(channel.least, *least);
    channel.most = std::max(channel.most, *most);
    for (int depth = 1; depth <= kMostKeptBands && depth < bands_.count; ++depth)
      for (int i = 0; i < rows_of(depth); ++i) {
        const std::int32_t value = values_[std::ptrdiff_t{c} * bands_.length(bands_.count - 1) +
                                           bands_[bands_.count - depth].first + i];
        channel.largest[depth - 1] = std::max(channel.largest[depth - 1], std::abs(value));
      }
  }
}

/// Which channels are too large for 16-bit samples, or for whole weights times their details.
void CookedBuilder::choose_wide() {
  constexpr double kStill = 1e-7;  // cm or radians
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    const std::int32_t* const largest = channel.largest;
    const bool has_details =
        std::any_of(largest, largest + kMostKeptBands, [](std::int32_t v) { return v != 0; });
    channel.changes |= has_details || channel.most - channel.least > kStill;
    channel.constant = 0.5 * (channel.least + channel.most);
    channel.is_wide |=
        channel.changes && (channel.most - channel.least > kMostRange ||
                            *std::max_element(largest, largest + kMostBands) > kMostValue);
    if (!channel.is_wide) continue;
    for (int b = 0; b < wide_bands_; ++b)
      if (largest[b] > kMostValue) wide_bands_ = b;
  }
}

/// Channels that are wide come eight at a time: of those that have no column yet, the ones with the
/// largest details make up the number.
void CookedBuilder::fill_wide() {
  int wide = 0;
  for (int c = 0; c < channel_count(); ++c) wide += channels_[c].is_wide ? 1 : 0;
  const auto size_of = [](const Channel& channel) {
    return *std::max_element(channel.largest, channel.largest + kMostBands);
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

int CookedBuilder::new_group() {
  if (kGroup * (groups_ + 1) > kMostColumns) return -1;
  for (int i = 0; i < kGroup; ++i) columns_[kGroup * groups_ + i] = {.is_free = true};
  return groups_++;
}

/// The first free column for a channel, from the wide ones' on if it is one, or a new one. -1:
/// there is none.
std::int32_t CookedBuilder::place(int channel) {
  std::int32_t column = channels_[channel].is_wide ? kGroup * normal_groups_ : 0;
  while (column < kGroup * groups_ && !columns_[column].is_free) ++column;
  if (column == kGroup * groups_ && new_group() < 0) return -1;
  columns_[column] = {.channel = channel, .factor = channels_[channel].factor};
  return column;
}

/// Which channels turn a joint, and how: as a rotor, as other turns, or not at all.
void CookedBuilder::place_joint(int j) {
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
    if (turning < 3) rotor.channel[turning] = static_cast<std::uint16_t>(number);
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
      channels_[joint.first_channel + c].changes = true;  // so that it has a column
      add(axis_of(joint.kinds[c]), joint.first_channel + c, false);
    }
  if (joint.has_axes) add(OtherTurn::kConstant, -1, true);
}

/// The columns in which most joints of a group of rotors have an angle are where the rotors want
/// them.
bool CookedBuilder::place_full_vectors() {
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

/// Angles that are not where their rotors want them, and all that no rotor wants.
bool CookedBuilder::place_others(bool wide) {
  for (int c = 0; c < channel_count(); ++c) {
    Channel& channel = channels_[c];
    if (!channel.changes || channel.is_wide != wide) continue;
    if (channel.column < 0) channel.column = place(c);
    if (channel.column < 0) return false;
    if (!is_rotation(channel.kind))
      moving_[moving_count_++] = {channel.joint, static_cast<std::uint16_t>(axis_of(channel.kind)),
                                  static_cast<std::uint32_t>(channel.column)};
  }
  return true;
}

/// Groups of columns that no rows are kept of: they get their values from others.
bool CookedBuilder::place_gathered_vectors() {
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

mcpr_result CookedBuilder::place_columns() {
  const auto too_many = failure(MCPR_LIMIT, 0, "more channels than a cooked clip can have");
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) place_joint(static_cast<int>(j));
  std::sort(rotors_, rotors_ + rotor_count_, [](const Rotor& a, const Rotor& b) {
    return a.angles != b.angles ? a.angles > b.angles : a.joint < b.joint;
  });
  if (!place_full_vectors()) return too_many;
  for (int k = 0; k < kGroup * groups_; ++k)
    if (columns_[k].channel >= 0) channels_[columns_[k].channel].column = k;
  fill_wide();
  if (!place_others(false)) return too_many;
  normal_groups_ = groups_;
  if (!place_others(true)) return too_many;
  row_groups_ = groups_;
  if (!place_gathered_vectors()) return too_many;
  const auto add_parts = [&](int first, int end, bool wide) {
    for (; first < end; first += kMostGroupsOfPart)
      parts_[part_count_++] = {
          .first_group = static_cast<std::uint16_t>(first),
          .groups = static_cast<std::uint16_t>(std::min(end - first, kMostGroupsOfPart)),
          .kept_bands = static_cast<std::uint8_t>(wide ? wide_bands_ : kMostBands),
          .wide_samples = static_cast<std::uint8_t>(wide ? 1 : 0)};
  };
  add_parts(0, normal_groups_, false);
  add_parts(normal_groups_, row_groups_, true);
  choose_bands();
  return kOk;
}

/// One band less to add up at every instant, where that takes hardly more bytes.
void CookedBuilder::choose_bands() {
  constexpr std::uint64_t kMostPercent = 101;
  const auto keep = [&](int bands) {
    for (int p = 0; p < part_count_; ++p)
      if (parts_[p].wide_samples == 0) parts_[p].kept_bands = static_cast<std::uint8_t>(bands);
    return lay_out(nullptr);
  };
  const std::uint64_t fewer = keep(kFewestBands);
  const std::uint64_t more = keep(kMostBands);
  if (100 * fewer <= kMostPercent * more) keep(kFewestBands);
}

std::uint64_t CookedBuilder::lay_out(std::byte* memory) {
  Block block(memory);
  mcpr_cooked head{};
  block.reserve(sizeof head);
  std::memcpy(head.magic, mcpr_cooked::kMagic, sizeof head.magic);
  head.version = mcpr_cooked::kVersion;
  head.sample_rate = clip_.sample_rate;
  head.frames = static_cast<std::uint32_t>(clip_.segments.frames);
  head.segment_length = static_cast<std::uint32_t>(clip_.segments.length);
  head.segment_overlap = static_cast<std::uint32_t>(clip_.segments.overlap);
  head.joints = clip_.joint_count;
  head.groups = static_cast<std::uint32_t>(groups_);
  head.row_groups = static_cast<std::uint32_t>(row_groups_);
  head.parts = static_cast<std::uint16_t>(part_count_);
  head.segments = static_cast<std::uint16_t>(clip_.segments.count());
  head.wavelet = clip_.motion(0).wavelet();
  head.loop = clip_.loop;
  lay_out_joints(block, head);
  lay_out_rotors(block, head);
  if (auto* const parts = block.reserve_for<CookedPart>(head.parts, head.part_table))
    std::copy_n(parts_, part_count_, parts);
  if (head.loop == LoopKind::Follows) {
    const int columns = kGroup * row_groups_;
    if (auto* const kinds =
            block.reserve_for<ColumnKind>(static_cast<std::uint64_t>(columns), head.column_kinds))
      for (int c = 0; c < columns; ++c) {
        kinds[c] = ColumnKind::Straight;
        if (columns_[c].channel < 0) continue;
        const Channel& channel = channels_[columns_[c].channel];
        if (clip_.joint_models()[channel.joint].parent < 0)
          kinds[c] = ColumnKind::Root;
        else if (is_rotation(channel.kind))
          kinds[c] = ColumnKind::HalfAngle;
      }
  }
  head.skeleton_bytes = static_cast<std::uint32_t>(block.used() - sizeof head);
  if (clip_.end_reach[0] > 0) {
    std::copy_n(clip_.end_reach, 2, head.end_reach);
    const int columns = kGroup * row_groups_;
    if (auto* const ends =
            block.reserve_for<float>(2 * static_cast<std::uint64_t>(columns), head.ends))
      for (int end = 0; end < 2; ++end)
        for (int c = 0; c < columns; ++c)
          ends[end * columns + c] = columns_[c].channel < 0
                                        ? 0
                                        : static_cast<float>(columns_[c].factor) *
                                              clip_.end_values(end)[columns_[c].channel];
  }
  auto* const rows =
      block.reserve_for<CookedRows>(std::uint64_t{head.parts} * head.segments, head.rows);
  for (int k = 0; k < head.segments; ++k) {
    load(k);
    for (int p = 0; p < part_count_; ++p) {
      const CookedRows made = lay_out_part(block, parts_[p]);
      if (rows != nullptr) rows[k * part_count_ + p] = made;
    }
  }
  block.round_up(8);
  head.bytes = block.used();
  if (memory == nullptr) return head.bytes;
  std::memcpy(memory, &head, sizeof head);
  auto* const made = std::launder(reinterpret_cast<mcpr_cooked*>(memory));
  made->checksum = checksum_of(*made);
  return head.bytes;
}

void CookedBuilder::lay_out_joints(Block& block, mcpr_cooked& head) {
  auto* const rest = block.reserve_for<mcpr_transform>(head.joints, head.rest, kAlignment);
  if (rest != nullptr) {
    for (std::uint32_t j = 0; j < head.joints; ++j) {
      const JointModel& joint = clip_.joint_models()[j];
      Matrix3 rotation;
      Vector3 origin = joint.offset;
      if (joint.has_axes) rotation = joint.parent_from_axes;
      for (int c = 0; c < joint.channels; ++c) {
        const Channel& channel = channels_[joint.first_channel + c];
        if (channel.changes) continue;
        if (is_rotation(channel.kind))
          turn_about(axis_of(channel.kind), channel.constant, rotation);
        else
          origin[axis_of(channel.kind)] += channel.constant;
      }
      if (joint.has_axes) rotation = rotation * joint.axes_from_joint;
      const Quaternion q = quaternion_from(rotation);
      for (int i = 0; i < 4; ++i) rest[j].rotation[i] = static_cast<float>(q.wxyz[i]);
      for (int i = 0; i < 3; ++i) rest[j].translation[i] = static_cast<float>(origin[i]);
      rest[j].translation[3] = 0;
    }
  }
  const auto gathered = static_cast<std::uint64_t>(kGroup * (groups_ - row_groups_));
  if (auto* const bases = block.reserve_for<float>(gathered, head.bases))
    for (std::uint64_t c = 0; c < gathered; ++c)
      bases[c] =
          static_cast<float>(columns_[kGroup * static_cast<std::uint64_t>(row_groups_) + c].base);
  // What does not change of a translation goes with the first column that moves it.
  for (int m = 0; m < moving_count_; ++m) {
    const JointModel& joint = clip_.joint_models()[moving_[m].joint];
    double base = joint.offset[moving_[m].axis];
    for (int c = 0; c < joint.channels; ++c) {
      const Channel& channel = channels_[joint.first_channel + c];
      if (!channel.changes && channel.kind == moving_[m].axis) base += channel.constant;
    }
    columns_[moving_[m].column].base = base;
  }
  head.moving_axes = static_cast<std::uint16_t>(moving_count_);
  if (auto* const moving =
          block.reserve_for<MovingAxis>(static_cast<std::uint64_t>(moving_count_), head.moving))
    std::copy_n(moving_, moving_count_, moving);
  head.added_columns = static_cast<std::uint16_t>(added_count_);
  if (auto* const added =
          block.reserve_for<AddedColumn>(static_cast<std::uint64_t>(added_count_), head.added))
    std::copy_n(added_, added_count_, added);
  head.other_turns = static_cast<std::uint16_t>(turn_count_);
  auto* const turns =
      block.reserve_for<OtherTurn>(static_cast<std::uint64_t>(turn_count_), head.turns);
  for (int t = 0; t < turn_count_; ++t) {
    OtherTurn turn = turns_[t].made;
    if (turns_[t].channel >= 0)
      turn.column = static_cast<std::uint32_t>(channels_[turns_[t].channel].column);
    if (turn.axis == OtherTurn::kConstant) {
      const JointModel& joint = clip_.joint_models()[turn.joint];
      const Quaternion q =
          quaternion_from(turns_[t].is_after ? joint.axes_from_joint : joint.parent_from_axes);
      if (auto* const made = block.reserve_for<float>(4, turn.column))
        for (int i = 0; i < 4; ++i) made[i] = static_cast<float>(q.wxyz[i]);
    }
    if (turns != nullptr) turns[t] = turn;
  }
}

void CookedBuilder::lay_out_rotors(Block& block, mcpr_cooked& head) {
  head.rotor_groups = static_cast<std::uint16_t>((rotor_count_ + kGroup - 1) / kGroup);
  auto* const groups = block.reserve_for<RotorGroup>(head.rotor_groups, head.rotors);
  for (int g = 0; g < head.rotor_groups; ++g) {
    const Rotor* const rotors = rotors_ + kGroup * g;
    RotorGroup group{
        .angles = rotors[0].angles,
        .joints = static_cast<std::uint8_t>(std::min(kGroup, rotor_count_ - kGroup * g))};
    for (int a = 0; a < group.angles; ++a)
      group.vector[a] = static_cast<std::uint16_t>(vectors_[g][a]);
    std::fill_n(group.joint, kGroup, RotorGroup::kNoJoint);
    bool has_axes = false;
    for (int i = 0; i < group.joints; ++i) {
      const auto bit = static_cast<std::uint8_t>(1U << i);
      group.joint[i] = rotors[i].joint;
      has_axes |= clip_.joint_models()[rotors[i].joint].has_axes;
      int axis[3] = {};
      for (int a = 0; a < rotors[i].angles; ++a) {
        axis[a] = axis_of(channels_[rotors[i].channel[a]].kind);
        group.has_angle[a] |= bit;
      }
      if (rotors[i].angles == 1) axis[1] = (axis[0] + 1) % 3;
      group.first_axis[axis[0]] |= bit;
      group.second_axis[axis[1]] |= bit;
      if ((axis[0] + 1) % 3 != axis[1]) group.is_odd |= bit;
    }
    if (has_axes) {
      if (auto* const around = block.reserve_for<float>(8 * kGroup, group.around))
        for (int side = 0; side < 2; ++side)
          for (int i = 0; i < kGroup; ++i) {
            Quaternion q;
            if (i < group.joints) {
              const JointModel& joint = clip_.joint_models()[rotors[i].joint];
              if (joint.has_axes)
                q = quaternion_from(side == 0 ? joint.parent_from_axes : joint.axes_from_joint);
            }
            for (int k = 0; k < 4; ++k)
              around[(4 * side + k) * kGroup + i] = static_cast<float>(q.wxyz[k]);
          }
    }
    if (groups != nullptr) groups[g] = group;
  }
}

CookedRows CookedBuilder::lay_out_part(Block& block, const CookedPart& part) {
  CookedRows rows;
  const int columns = kGroup * part.groups;
  const int kept = std::min<int>(part.kept_bands, bands_.count - 1);
  float* const scales =
      block.reserve_for<float>(3 * static_cast<std::uint64_t>(columns), rows.scales);
  // Whole sums are times 2^15.
  for (int c = 0; scales != nullptr && c < columns; ++c) {
    const Column& column = columns_[kGroup * part.first_group + c];
    scales[c] = static_cast<float>(column.base);
    if (column.channel >= 0)
      scales[2 * columns + c] =
          static_cast<float>(steps_[column.channel] * column.factor * 0x1p-15);
  }
  const int samples = std::max(bands_.length(bands_.count - 1 - kept), kSampleWindow);
  const std::size_t width = part.wide_samples != 0 ? 4 : 2;
  rows.samples =
      block.reserve(width * static_cast<std::size_t>(columns) * static_cast<std::size_t>(samples));
  std::byte* const sample_rows = block.at(rows.samples);
  for (int c = 0; sample_rows != nullptr && c < columns; ++c) {
    const Column& column = columns_[kGroup * part.first_group + c];
    if (column.channel < 0) continue;
    find_samples(column.channel, kept, samples_);
    const int count = bands_.length(bands_.count - 1 - kept);
    for (int i = 0; i < count; ++i) samples_[i] *= column.factor;
    if (part.wide_samples != 0) {
      scales[columns + c] = 1;
      for (int i = 0; i < count; ++i) {
        const auto sample = static_cast<float>(samples_[i]);
        std::memcpy(sample_rows + 4 * (std::ptrdiff_t{i} * columns + c), &sample, sizeof sample);
      }
      continue;
    }
    const auto [least, most] = std::minmax_element(samples_, samples_ + count);
    const double middle = 0.5 * (*least + *most);
    const double scale = std::max((*most - *least) / 65534, 1e-30);
    scales[c] += static_cast<float>(middle);
    scales[columns + c] = static_cast<float>(scale);
    for (int i = 0; i < count; ++i) {
      const auto sample = static_cast<std::int16_t>(std::lround((samples_[i] - middle) / scale));
      std::memcpy(sample_rows + 2 * (std::ptrdiff_t{i} * columns + c), &sample, sizeof sample);
    }
  }
  CookedBand* const bands = block.reserve_for<CookedBand>(part.kept_bands, rows.bands);
  for (int depth = 1; depth <= kept; ++depth) {
    const CookedBand band = lay_out_band(block, part, depth);
    if (bands != nullptr) bands[depth - 1] = band;
  }
  return rows;
}

std::int32_t CookedBuilder::value(int column, int depth, int row) const {
  const std::int32_t channel = columns_[column].channel;
  if (channel < 0) return 0;
  return values_[std::ptrdiff_t{channel} * bands_.length(bands_.count - 1) +
                 bands_[bands_.count - depth].first + row];
}

/// The smallest of all kinds, where a byte of entries, which take time one by one, counts as more.
CookedBand CookedBuilder::lay_out_band(Block& block, const CookedPart& part, int depth) {
  constexpr std::uint64_t kEntryIsWorth = 3;  // bytes of dense rows
  const int rows = rows_of(depth);
  const int columns = kGroup * part.groups;
  CookedBand best;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t entries_of_best = 0;
  for (const RowKind kind :
       {RowKind::None, RowKind::Crumbs, RowKind::Nibbles, RowKind::Bytes, RowKind::Words}) {
    CookedBand band{.kind = kind};
    std::uint64_t entries = 0;
    for (int c = 0; c < columns; ++c)
      for (int i = 0; i < rows; ++i)
        entries += entries_for(left_by(kind, value(kGroup * part.first_group + c, depth, i)));
    while (band.log2_rows < kMostLog2RowsOfBlock &&
           (entries << (band.log2_rows + 1)) / static_cast<std::uint64_t>(rows) <= kMostPerBlock)
      ++band.log2_rows;
    const std::uint64_t blocks =
        entries == 0 ? 0 : static_cast<std::uint64_t>((rows - 1) >> band.log2_rows) + 1;
    const std::uint64_t dense =
        static_cast<std::uint64_t>(bundles_of(kind, rows)) * bundle_bytes(kind) * part.groups;
    const std::uint64_t cost = dense + kEntryIsWorth * entries + 2 * blocks;
    if (cost >= least || entries > kMostEntries || blocks > kMostEntries) continue;
    least = cost;
    band.blocks = static_cast<std::uint16_t>(blocks);
    best = band;
    entries_of_best = entries;
  }
  if (best.kind != RowKind::None) {
    best.rows = block.reserve(static_cast<std::uint64_t>(bundles_of(best.kind, rows)) *
                              bundle_bytes(best.kind) * part.groups);
    if (std::byte* const memory = block.at(best.rows)) put_dense(memory, part, best.kind, depth);
  }
  if (best.blocks > 0) {
    best.entries = block.reserve(2 * (std::uint64_t{best.blocks} + 1 + entries_of_best));
    if (std::byte* const memory = block.at(best.entries)) put_entries(memory, part, best, depth);
  }
  return best;
}

void CookedBuilder::put_dense(std::byte* rows, const CookedPart& part, RowKind kind,
                              int depth) const {
  const int count = rows_of(depth);
  const int together = rows_together(kind);
  const Limits limits = limits_of(kind);
  const auto put = [&](unsigned bits, int bytes) {
    for (int i = 0; i < bytes; ++i) *rows++ = static_cast<std::byte>(bits >> (8 * i));
  };
  for (int bundle = 0; bundle < bundles_of(kind, count); ++bundle)
    for (int c = 0; c < kGroup * part.groups; ++c) {
      unsigned bits = 0;
      for (int i = 0; i < together; ++i) {
        const int row = together * bundle + i;
        const std::int32_t number =
            row < count ? std::clamp(value(kGroup * part.first_group + c, depth, row), limits.least,
                                     limits.most)
                        : 0;
        if (kind == RowKind::Crumbs)
          bits |= static_cast<unsigned>(number + 2) << (2 * i);
        else if (kind == RowKind::Nibbles)
          bits |= static_cast<unsigned>(number + 8) << (4 * i);
        else if (kind == RowKind::Bytes)
          bits |= (static_cast<unsigned>(number) & 0xFF) << (8 * i);
        else
          bits |= (static_cast<unsigned>(number) & 0xFFFF) << (16 * i);
      }
      put(bits, static_cast<int>(bundle_bytes(kind)) / kGroup);
    }
}

std::uint64_t CookedBuilder::put_entries(std::byte* memory, const CookedPart& part,
                                         const CookedBand& band, int depth) const {
  const int count = rows_of(depth);
  const auto put = [&](std::uint64_t at, std::uint16_t word) {
    std::memcpy(memory + 2 * at, &word, sizeof word);
  };
  std::uint64_t entries = 0;
  for (int block = 0; block < band.blocks; ++block) {
    put(static_cast<std::uint64_t>(block), static_cast<std::uint16_t>(entries));
    const int end = std::min(count, (block + 1) << band.log2_rows);
    for (int row = block << band.log2_rows; row < end; ++row)
      for (int c = 0; c < kGroup * part.groups; ++c) {
        std::int32_t left = left_by(band.kind, value(kGroup * part.first_group + c, depth, row));
        while (left != 0) {
          const std::int32_t now = std::clamp(left, kLeastOfEntry, kMostOfEntry);
          put(band.blocks + 1U + entries++,
              static_cast<std::uint16_t>(static_cast<unsigned>(now) << (kColumnBits + kRowBits) |
                                         (static_cast<unsigned>(row) & ((1U << kRowBits) - 1))
                                             << kColumnBits |
                                         static_cast<unsigned>(c)));
          left -= now;
        }
      }
  }
  put(band.blocks, static_cast<std::uint16_t>(entries));
  return entries;
}

}  // namespace mocapress::runtime
