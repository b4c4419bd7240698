// SPDX-License-Identifier: MIT
#include "core/runtime/pose/pose_selection.h"

#include <algorithm>

namespace mocapress::runtime {

bool are_joints_of(const mcpr_cooked& clip, const std::uint16_t* joints, std::uint32_t count) {
  std::bitset<kMostJoints> seen;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (joints[i] >= clip.joints || seen[joints[i]]) return false;
    seen[joints[i]] = true;
  }
  return true;
}

}  // namespace mocapress::runtime

mcpr_selection::mcpr_selection(mocapress::runtime::Memory& memory, const mcpr_cooked& of)
    : clip(&of),
      places(memory.take<std::uint16_t>(of.joints)),
      rotors(memory.take<mocapress::runtime::RotorPlaces>(of.rotor_groups)),
      parts(memory.take<mocapress::runtime::GroupRange>(of.parts)) {}

void mcpr_selection::select(const std::uint16_t* from, std::uint32_t count) {
  using namespace mocapress::runtime;
  joints = from;
  joint_count = count;
  std::fill_n(places, clip->joints, kNowhere);
  for (std::uint32_t i = 0; i < count; ++i) places[joints[i]] = static_cast<std::uint16_t>(i);
  find_rotors();
  want_columns();
}

void mcpr_selection::select_within(const mcpr_selection* whole, const std::uint16_t* from,
                                   std::uint32_t count) {
  using namespace mocapress::runtime;
  joint_count = whole == nullptr ? clip->joints : whole->joint_count;
  std::fill_n(places, clip->joints, kNowhere);
  for (std::uint32_t i = 0; i < count; ++i)
    places[from[i]] = whole == nullptr ? from[i] : whole->places[from[i]];
  find_rotors();
  want_columns();
}

void mcpr_selection::find_rotors() {
  using namespace mocapress::runtime;
  rotor_groups = 0;
  for (std::uint16_t g = 0; g < clip->rotor_groups; ++g) {
    const RotorGroup& group = clip->at<RotorGroup>(clip->rotors)[g];
    RotorPlaces made;
    made.group = g;
    std::uint16_t next = kNowhere;
    for (int i = group.joints; i-- > 0;) {
      if (places[group.joint[i]] != kNowhere) {
        next = places[group.joint[i]];
        made.joints = std::max<std::uint16_t>(made.joints, static_cast<std::uint16_t>(i + 1));
      }
      made.place[i] = next;
    }
    if (made.joints > 0) rotors[rotor_groups++] = made;
  }
}

void mcpr_selection::want_columns() {
  using namespace mocapress::runtime;
  wanted.reset();
  for (std::uint32_t r = 0; r < rotor_groups; ++r) {
    const RotorGroup& group = clip->at<RotorGroup>(clip->rotors)[rotors[r].group];
    for (int a = 0; a < group.angles; ++a) wanted[group.vector[a]] = true;
  }
  for (int i = 0; i < clip->moving_axes; ++i) {
    const MovingAxis& moving = clip->at<MovingAxis>(clip->moving)[i];
    if (places[moving.joint] != kNowhere) wanted[moving.column / kGroup] = true;
  }
  for (int i = 0; i < clip->other_turns; ++i) {
    const OtherTurn& turn = clip->at<OtherTurn>(clip->turns)[i];
    if (turn.axis != OtherTurn::kConstant && places[turn.joint] != kNowhere)
      wanted[turn.column / kGroup] = true;
  }
  for (int i = 0; i < clip->added_columns; ++i) {
    const AddedColumn& added = clip->at<AddedColumn>(clip->added)[i];
    if (wanted[added.to / kGroup]) wanted[added.from / kGroup] = true;
  }
  for (int p = 0; p < clip->parts; ++p) {
    const CookedPart& part = clip->part(p);
    std::size_t first = part.first_group;
    std::size_t end = first + part.groups;
    while (first < end && !wanted[first]) ++first;
    while (end > first && !wanted[end - 1]) --end;
    parts[p] = {static_cast<std::uint16_t>(first - part.first_group),
                static_cast<std::uint16_t>(end - first)};
  }
}
