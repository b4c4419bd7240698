// SPDX-License-Identifier: MIT
#include "core/bank/cooked_tables.h"

#include <cstring>
#include <string>

#include "core/codec/format/format_error.h"
#include "core/runtime/format/bank_skeleton.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/pose/cooked_builder.h"
#include "core/runtime/pose/cooked_check.h"

namespace mocapress {
namespace {

using runtime::TableOffset;

/// Copies a clip's tables into the tables that a bank's clips share.
class TableMover {
 public:
  TableMover(const mcpr_cooked& from, SharedTables& to) : from_(from), to_(to) {}

  /// Stores the tables' new offsets in the head.
  void move(mcpr_cooked& head) {
    const std::uint32_t columns = runtime::kGroup * from_.groups;
    const std::uint32_t row_columns = runtime::kGroup * from_.row_groups;
    head.rest = put(all_of<mcpr_transform>(from_.rest, from_.joints));
    std::vector rotors = all_of<runtime::RotorGroup>(from_.rotors, from_.rotor_groups);
    for (runtime::RotorGroup& group : rotors)
      if (group.around_kind != runtime::AroundKind::None)
        group.around = put(all_of<float>(group.around, runtime::floats_around(group.around_kind)));
    head.rotors = put(rotors);
    head.moving = put(all_of<runtime::MovingAxis>(from_.moving, from_.moving_axes));
    head.added = put(all_of<runtime::AddedColumn>(from_.added, from_.added_columns));
    std::vector turns = all_of<runtime::OtherTurn>(from_.turns, from_.other_turns);
    for (runtime::OtherTurn& turn : turns)
      if (turn.axis == runtime::OtherTurn::kConstant)
        turn.column = put(all_of<float>(TableOffset{turn.column}, 4)).bytes;
    head.turns = put(turns);
    head.bases = put(all_of<float>(from_.bases, columns - row_columns));
    head.part_table = put(all_of<runtime::CookedPart>(from_.part_table, from_.parts));
    if (from_.loop == runtime::LoopKind::Follows)
      head.column_kinds = put(all_of<runtime::ColumnKind>(from_.column_kinds, row_columns));
  }

 private:
  template <typename T>
  std::vector<T> all_of(TableOffset offset, std::size_t count) const {
    const T* const first = from_.at<T>(offset);
    return {first, first + count};
  }
  template <typename T>
  TableOffset put(const std::vector<T>& table) {
    return {to_.intern(std::as_bytes(std::span(table)))};
  }

  const mcpr_cooked& from_;
  SharedTables& to_;
};

std::vector<std::byte> skeleton_of(const mcpr_clip* clip) {
  const std::uint32_t joints = mcpr::describe(clip).joints;
  std::vector<runtime::BankJoint> made(joints);
  std::string names;
  const std::size_t first_name = sizeof joints + joints * sizeof(runtime::BankJoint);
  for (std::uint32_t j = 0; j < joints; ++j) {
    mcpr_joint joint{};
    mcpr_result result;
    mcpr_clip_joint(clip, j, &joint, &result);
    require(result);
    made[j].parent = joint.parent;
    made[j].name = static_cast<std::uint32_t>(first_name + names.size());
    std::memcpy(made[j].offset, joint.offset, sizeof joint.offset);
    made[j].has_end_site = joint.has_end_site;
    if (joint.has_end_site != 0)
      std::memcpy(made[j].end_site, joint.end_site, sizeof joint.end_site);
    names.append(joint.name, std::strlen(joint.name) + 1);
  }
  std::vector<std::byte> item(first_name + names.size());
  std::memcpy(item.data(), &joints, sizeof joints);
  std::memcpy(item.data() + sizeof joints, made.data(), first_name - sizeof joints);
  std::memcpy(item.data() + first_name, names.data(), names.size());
  return item;
}

std::uint64_t bytes_without_ik(const mcpr_clip& clip, const Cooking& cooking) {
  OwnMemory<runtime::CookedBuilder> builder(
      clip, mcpr_cook_options{.detail_bands = cooking.detail_bands});
  require(builder->prepare());
  const runtime::CookedBuilder::Size size = builder->lay_out_apart(nullptr, nullptr);
  return size.clip + size.tables;
}

}  // namespace

ClipForBank cook_for_bank(std::span<const std::byte> file, const Cooking& cooking) {
  mcpr_info info{};
  mcpr_result result;
  mcpr_inspect(file.data(), file.size(), nullptr, &info, &result);
  require(result);
  const auto loaded = mcpr::load(file);
  require(loaded.result);
  const mcpr_clip* const clip = loaded->get();
  const mcpr_cook_options options{.apply_ik = cooking.apply_ik ? 1 : 0,
                                  .ik_error = cooking.ik_error.value_or(info.error),
                                  .detail_bands = cooking.detail_bands};
  OwnMemory<runtime::CookedBuilder> builder(*clip, options);
  require(builder->prepare());
  const runtime::CookedBuilder::Size size = builder->lay_out_apart(nullptr, nullptr);
  ClipForBank made{AlignedBytes(static_cast<std::size_t>(size.clip)),
                   AlignedBytes(static_cast<std::size_t>(size.tables)), skeleton_of(clip)};
  std::memset(made.clip.data(), 0, made.clip.size());
  std::memset(made.tables.data(), 0, made.tables.size());
  builder->lay_out_apart(made.clip.data(), made.tables.data());
  reinterpret_cast<mcpr_cooked*>(made.clip.data())->tables = made.tables.data() - made.clip.data();
  if (cooking.apply_ik && info.effectors > 0) {
    const std::uint64_t without = bytes_without_ik(*clip, cooking);
    const std::uint64_t with = size.clip + size.tables;
    made.ik_bytes = with > without ? with - without : 0;
  }
  return made;
}

std::vector<std::byte> put_tables(const mcpr_cooked& clip, SharedTables& tables) {
  // Clips can only be read from aligned memory.
  const AlignedBytes copy(static_cast<std::size_t>(clip.bytes));
  std::memcpy(copy.data(), &clip, copy.size());
  auto* const head = reinterpret_cast<mcpr_cooked*>(copy.data());
  TableMover(clip, tables).move(*head);
  head->tables = 0;
  head->checksum = runtime::checksum_of(*head);
  return {copy.data(), copy.data() + copy.size()};
}

}  // namespace mocapress
