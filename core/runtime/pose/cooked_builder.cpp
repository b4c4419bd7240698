// SPDX-License-Identifier: MIT
#include "core/runtime/pose/cooked_builder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <span>

#include "core/runtime/pose/cooked_check.h"
#include "core/runtime/pose/cooked_rows.h"

namespace mocapress::runtime {
namespace {

struct Quaternion {
  double wxyz[4] = {1, 0, 0, 0};
};

Quaternion quaternion_from(const Matrix3& rotation) {
  Quaternion q;
  quaternion_of(rotation, q.wxyz);
  return q;
}

bool is_inverse(const Matrix3& a, const Matrix3& b) {
  constexpr double kMost = 1e-6;
  const Matrix3 both = a * b;
  bool is_identity = true;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      is_identity = is_identity && std::abs(both(row, column) - (row == column ? 1 : 0)) < kMost;
  return is_identity;
}

/// Writes one joint's part of the table for AroundKind::Inverses: the directions of its three axes.
/// For an odd permutation of the axes, the third direction is negated.
void put_turned_axes(const Matrix3& parent_from_axes, const int (&axes)[3], bool is_odd,
                     float* to) {
  for (int row = 0; row < 3; ++row)
    for (int i = 0; i < 3; ++i) {
      const double value = parent_from_axes(row, axes[i]);
      to[(3 * row + i) * kGroup] = static_cast<float>(i == 2 && is_odd ? -value : value);
    }
}

/// Writes one joint's part of the table for AroundKind::Any.
void put_quaternions(const Matrix3& before, const Matrix3& after, float* to) {
  for (const Matrix3* const side : {&before, &after})
    for (const double value : quaternion_from(*side).wxyz) {
      *to = static_cast<float>(value);
      to += kGroup;
    }
}

CookedColumns::BandRange bands_of(const mcpr_cook_options& options) {
  if (options.detail_bands == 0) return {};
  const auto bands = static_cast<int>(options.detail_bands);
  return {bands, bands};
}

}  // namespace

CookedBuilder::CookedBuilder(Memory& memory, const mcpr_clip& clip,
                             const mcpr_cook_options& options)
    : clip_(clip.block),
      has_skeleton_(options.skeleton != 0),
      coefficients_(memory, clip.block, options),
      columns_(memory, clip.block, coefficients_, bands_of(options)) {}

mcpr_result CookedBuilder::prepare() {
  coefficients_.prepare();
  const mcpr_result result = columns_.place();
  if (!failed(result)) choose_bands();
  return result;
}

/// Chooses the number of detail bands. One band less saves time at every instant; it is left out
/// unless that makes the clip more than 1 % larger.
void CookedBuilder::choose_bands() {
  constexpr std::uint64_t kMostPercent = 101;
  const auto [fewest, most] = columns_.bands();
  if (fewest == most) return;
  columns_.keep_bands(fewest);
  const std::uint64_t fewer = lay_out(nullptr);
  columns_.keep_bands(most);
  const std::uint64_t more = lay_out(nullptr);
  if (100 * fewer <= kMostPercent * more) columns_.keep_bands(fewest);
}

std::uint64_t CookedBuilder::lay_out(std::byte* memory) {
  CookedBlock block(memory);
  return lay_out(block, block, memory);
}

CookedBuilder::Size CookedBuilder::lay_out_apart(std::byte* memory, std::byte* tables) {
  CookedBlock block(memory);
  CookedBlock apart(tables);
  apart.reserve(kAlignment);
  const std::uint64_t size = lay_out(block, apart, memory);
  return {size, apart.used()};
}

std::uint64_t CookedBuilder::lay_out(CookedBlock& block, CookedBlock& tables, std::byte* memory) {
  mcpr_cooked head{};
  block.reserve(sizeof head);
  const std::uint64_t first_table = tables.used();
  if (has_skeleton_) lay_out_skeleton(block);
  std::memcpy(head.magic, mcpr_cooked::kMagic, sizeof head.magic);
  head.version = mcpr_cooked::kVersion;
  head.sample_rate = clip_.sample_rate;
  head.frames = static_cast<std::uint32_t>(clip_.segments.frames);
  head.segment_length = static_cast<std::uint32_t>(clip_.segments.length);
  head.segment_overlap = static_cast<std::uint32_t>(clip_.segments.overlap);
  head.joints = clip_.joint_count;
  head.has_skeleton = has_skeleton_ ? 1 : 0;
  head.groups = static_cast<std::uint32_t>(columns_.groups());
  head.row_groups = static_cast<std::uint32_t>(columns_.row_groups());
  head.parts = static_cast<std::uint16_t>(columns_.parts().size());
  head.segments = static_cast<std::uint16_t>(clip_.segments.count());
  head.wavelet = clip_.motion(0).wavelet();
  head.loop = clip_.loop;
  lay_out_joints(tables, head);
  lay_out_rotors(tables, head);
  if (auto* const parts = tables.reserve_for<CookedPart>(head.parts, head.part_table))
    std::copy_n(columns_.parts().begin(), columns_.parts().size(), parts);
  if (head.loop == LoopKind::Follows) {
    const int columns = kGroup * columns_.row_groups();
    if (auto* const kinds =
            tables.reserve_for<ColumnKind>(static_cast<std::uint64_t>(columns), head.column_kinds))
      for (int c = 0; c < columns; ++c) {
        kinds[c] = ColumnKind::Straight;
        if (columns_.column(c).channel < 0) continue;
        const CookedColumns::Channel& channel = columns_.channel(columns_.column(c).channel);
        if (clip_.joint_models()[channel.joint].parent < 0)
          kinds[c] = ColumnKind::Root;
        else if (is_rotation(channel.kind))
          kinds[c] = ColumnKind::HalfAngle;
      }
  }
  head.skeleton_bytes = static_cast<std::uint32_t>(tables.used() - first_table);
  if (clip_.end_reaches.any()) {
    head.end_reaches = clip_.end_reaches;
    lay_out_ends(block, head);
  }
  auto* const rows =
      block.reserve_for<CookedRows>(std::uint64_t{head.parts} * head.segments, head.rows);
  const int entry_bands = head.entry_parts() * kMostKeptBands;
  auto* const entries = block.reserve_for<CookedEntries>(
      static_cast<std::uint64_t>(entry_bands) * head.segments, head.entries);
  for (int k = 0; k < head.segments; ++k) {
    coefficients_.load(k);
    lay_out_rows(block, columns_, coefficients_, rows != nullptr ? rows + k * head.parts : nullptr,
                 entries != nullptr ? entries + k * entry_bands : nullptr);
  }
  if (const mcpr_tracks* const tracks = clip_.scalar_tracks())
    if (auto* const copy = block.reserve_for<std::byte>(tracks->bytes, head.tracks, 8))
      std::memcpy(copy, tracks, tracks->bytes);
  static_assert(kSampleBytesBeyond <= 2 * kEntriesBeyond);
  block.reserve(2 * kEntriesBeyond, 2);
  block.round_up(8);
  head.bytes = block.used();
  if (memory == nullptr) return head.bytes;
  std::memcpy(memory, &head, sizeof head);
  auto* const made = std::launder(reinterpret_cast<mcpr_cooked*>(memory));
  made->checksum = checksum_of(*made);
  return head.bytes;
}

/// Stores a skeleton item, after its size: names, parents and offsets of the joints.
void CookedBuilder::lay_out_skeleton(CookedBlock& block) {
  const char* const names = clip_.at<char>(clip_.names);
  const JointModel* const models = clip_.joint_models();
  std::uint32_t size = 0;
  const auto head = static_cast<std::uint32_t>(sizeof size + clip_.joint_count * sizeof(BankJoint));
  std::uint32_t item_bytes = head;
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j)
    item_bytes += static_cast<std::uint32_t>(std::strlen(names + models[j].name) + 1);
  std::byte* const at = block.at(block.reserve(sizeof size + item_bytes));
  if (at == nullptr) return;
  std::byte* const item = at + sizeof size;
  std::memcpy(at, &item_bytes, sizeof item_bytes);
  std::memcpy(item, &clip_.joint_count, sizeof clip_.joint_count);
  std::uint32_t name = head;
  for (std::uint32_t j = 0; j < clip_.joint_count; ++j) {
    const JointModel& model = models[j];
    BankJoint joint{.parent = model.parent, .name = name, .has_end_site = model.has_end_site};
    for (int i = 0; i < 3; ++i) joint.offset[i] = static_cast<float>(model.offset[i]);
    if (model.has_end_site) std::copy_n(model.end_site, 3, joint.end_site);
    std::memcpy(item + sizeof size + j * sizeof joint, &joint, sizeof joint);
    const std::size_t length = std::strlen(names + model.name) + 1;
    std::memcpy(item + name, names + model.name, length);
    name += static_cast<std::uint32_t>(length);
  }
}

/// Stores the end corrections. Few channels have one, so only nonzero values are stored.
void CookedBuilder::lay_out_ends(CookedBlock& block, mcpr_cooked& head) {
  const int ends = head.end_reaches.count();
  const int columns = kGroup * columns_.row_groups();
  const auto lacking = [&](int end, int column) {
    const std::int32_t channel = columns_.column(column).channel;
    return channel < 0 ? 0.0 : static_cast<double>(coefficients_.end_value(end, channel));
  };
  auto* marks = block.reserve_for<std::uint8_t>(
      static_cast<std::uint64_t>(ends * columns_.row_groups()), head.ends);
  std::uint64_t count = 0;
  for (int end = 0; end < ends; ++end)
    for (int c = 0; c < columns; ++c) {
      if (lacking(end, c) == 0) continue;
      ++count;
      if (marks != nullptr)
        marks[(end * columns + c) / kGroup] |= static_cast<std::uint8_t>(1U << c % kGroup);
    }
  std::uint32_t values_at = 0;
  auto* values = block.reserve_for<std::int16_t>(count, values_at);
  for (int end = 0; values != nullptr && end < ends; ++end) {
    coefficients_.load(end == kFirstPose ? 0 : head.segments - 1);
    const auto in_steps = [&](int c) {
      return lacking(end, c) / (coefficients_.step(columns_.column(c).channel) * 0x1p-15);
    };
    double largest = 0;
    for (int c = 0; c < columns; ++c)
      if (lacking(end, c) != 0) largest = std::max(largest, std::abs(in_steps(c)));
    head.end_units[end] = static_cast<float>(largest / 32767);
    for (int c = 0; c < columns; ++c)
      if (lacking(end, c) != 0)
        *values++ = static_cast<std::int16_t>(std::lround(in_steps(c) / largest * 32767));
  }
}

void CookedBuilder::lay_out_joints(CookedBlock& tables, mcpr_cooked& head) {
  auto* const rest = tables.reserve_for<mcpr_transform>(head.joints, head.rest, kAlignment);
  if (rest != nullptr) {
    for (std::uint32_t j = 0; j < head.joints; ++j) {
      const JointModel& joint = clip_.joint_models()[j];
      Matrix3 rotation;
      Vector3 origin = joint.offset;
      bool is_turned = false;
      if (joint.has_axes) rotation = joint.parent_from_axes;
      for (int c = 0; c < joint.channels; ++c) {
        const CookedColumns::Channel& channel = columns_.channel(joint.first_channel + c);
        is_turned |= channel.changes && is_rotation(channel.kind);
        if (channel.changes) continue;
        if (is_rotation(channel.kind))
          turn_about(axis_of(channel.kind), channel.constant, rotation);
        else
          origin[axis_of(channel.kind)] += channel.constant;
      }
      if (joint.has_axes) rotation = rotation * joint.axes_from_joint;
      // This rotation is not used. The identity makes tables of more clips equal, so that a bank
      // shares them.
      if (is_turned) rotation = {};
      const Quaternion q = quaternion_from(rotation);
      for (int i = 0; i < 4; ++i) rest[j].rotation[i] = static_cast<float>(q.wxyz[i]);
      for (int i = 0; i < 3; ++i) rest[j].translation[i] = static_cast<float>(origin[i]);
      rest[j].translation[3] = 0;
    }
    for (const MovingAxis& moving : columns_.moving())
      rest[moving.joint].translation[moving.axis] = 0;
  }
  const int first_gathered = kGroup * columns_.row_groups();
  const auto gathered = static_cast<std::uint64_t>(kGroup * columns_.groups() - first_gathered);
  if (auto* const bases = tables.reserve_for<float>(gathered, head.bases))
    for (int c = 0; c < static_cast<int>(gathered); ++c)
      bases[c] = static_cast<float>(columns_.column(first_gathered + c).base);
  head.moving_axes = static_cast<std::uint16_t>(columns_.moving().size());
  if (auto* const moving = tables.reserve_for<MovingAxis>(head.moving_axes, head.moving))
    std::copy_n(columns_.moving().begin(), columns_.moving().size(), moving);
  head.added_columns = static_cast<std::uint16_t>(columns_.added().size());
  if (auto* const added = tables.reserve_for<AddedColumn>(head.added_columns, head.added))
    std::copy_n(columns_.added().begin(), columns_.added().size(), added);
  head.other_turns = static_cast<std::uint16_t>(columns_.turns().size());
  auto* turns = tables.reserve_for<OtherTurn>(head.other_turns, head.turns);
  for (const CookedColumns::Turn& placed : columns_.turns()) {
    OtherTurn turn = placed.made;
    if (placed.channel >= 0)
      turn.column = static_cast<std::uint32_t>(columns_.channel(placed.channel).column);
    if (turn.axis == OtherTurn::kConstant) {
      const JointModel& joint = clip_.joint_models()[turn.joint];
      const Quaternion q =
          quaternion_from(placed.is_after ? joint.axes_from_joint : joint.parent_from_axes);
      if (auto* const made = tables.reserve_for<float>(4, turn.column))
        for (int i = 0; i < 4; ++i) made[i] = static_cast<float>(q.wxyz[i]);
    }
    if (turns != nullptr) *turns++ = turn;
  }
}

void CookedBuilder::lay_out_rotors(CookedBlock& tables, mcpr_cooked& head) {
  head.rotor_groups = static_cast<std::uint16_t>((columns_.rotors().size() + kGroup - 1) / kGroup);
  auto* const groups = tables.reserve_for<RotorGroup>(head.rotor_groups, head.rotors);
  for (int g = 0; g < head.rotor_groups; ++g) {
    const std::span all = columns_.rotors().subspan(static_cast<std::size_t>(kGroup * g));
    const std::span rotors = all.first(std::min<std::size_t>(kGroup, all.size()));
    RotorGroup group{.angles = rotors[0].angles,
                     .joints = static_cast<std::uint8_t>(rotors.size())};
    for (int a = 0; a < group.angles; ++a)
      group.vector[a] = static_cast<std::uint16_t>(columns_.vectors(g)[a]);
    group.are_near = 7;
    std::fill_n(group.joint, kGroup, RotorGroup::kNoJoint);
    bool has_axes = false;
    bool are_inverses = true;
    int axes[kGroup][3] = {};
    for (int i = 0; i < group.joints; ++i) {
      const auto bit = static_cast<std::uint8_t>(1U << i);
      group.joint[i] = rotors[i].joint;
      group.are_near &= rotors[i].are_near;
      const JointModel& joint = clip_.joint_models()[rotors[i].joint];
      has_axes |= joint.has_axes;
      are_inverses &= !joint.has_axes || is_inverse(joint.parent_from_axes, joint.axes_from_joint);
      int(&axis)[3] = axes[i];
      for (int a = 0; a < rotors[i].angles; ++a) {
        axis[a] = axis_of(columns_.channel(rotors[i].channel[a]).kind);
        group.has_angle[a] |= bit;
      }
      if (rotors[i].angles == 1) axis[1] = (axis[0] + 1) % 3;
      axis[2] = 3 - axis[0] - axis[1];
      group.first_axis[axis[0]] |= bit;
      group.second_axis[axis[1]] |= bit;
      if ((axis[0] + 1) % 3 != axis[1]) group.is_odd |= bit;
    }
    if (has_axes) {
      group.around_kind = are_inverses ? AroundKind::Inverses : AroundKind::Any;
      auto* const around =
          tables.reserve_for<float>(floats_around(group.around_kind), group.around);
      for (int i = 0; around != nullptr && i < group.joints; ++i) {
        const JointModel& joint = clip_.joint_models()[rotors[i].joint];
        const Matrix3 before = joint.has_axes ? joint.parent_from_axes : Matrix3();
        if (are_inverses)
          put_turned_axes(before, axes[i], (group.is_odd >> i & 1) != 0, around + i);
        else
          put_quaternions(before, joint.has_axes ? joint.axes_from_joint : Matrix3(), around + i);
      }
    }
    if (groups != nullptr) groups[g] = group;
  }
}

}  // namespace mocapress::runtime
