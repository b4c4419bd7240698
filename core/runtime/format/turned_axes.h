// SPDX-License-Identifier: MIT
// Constant rotations before and after the rotation of a joint's channels: FORMAT.md, AXES.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kTurnBits = 5;     // bits of each of the six coded numbers
inline constexpr int kFixedTurns = 16;  // units per half turn
inline constexpr std::uint32_t kTurnedAxesBytes = 4;

/// True if a joint's axes may be turned: it has a parent, and its rotation channels turn about
/// three different axes.
inline bool may_turn_axes(const JointModel& joint) {
  int axes = 0;
  int turns = 0;
  for (int c = 0; c < joint.channels; ++c)
    if (is_rotation(joint.kinds[c])) {
      axes |= 1 << axis_of(joint.kinds[c]);
      ++turns;
    }
  return joint.parent >= 0 && turns == 3 && axes == 7;
}

/// The coded form: two rotation vectors (axis times angle), x y z in units of pi / 16.
struct TurnedAxes {
  std::int8_t before[3] = {};
  std::int8_t after[3] = {};

  std::uint32_t code() const {
    std::uint32_t word = 0;
    for (int i = 0; i < 3; ++i) {
      word |= (static_cast<std::uint32_t>(before[i]) & 31U) << (kTurnBits * i);
      word |= (static_cast<std::uint32_t>(after[i]) & 31U) << (kTurnBits * (3 + i));
    }
    return word;
  }

  /// Decodes a word. False if it is not a valid code.
  bool set(std::uint32_t word) {
    if (word >> (6 * kTurnBits) != 0) return false;
    for (int i = 0; i < 3; ++i) {
      before[i] = number(word >> (kTurnBits * i));
      after[i] = number(word >> (kTurnBits * (3 + i)));
    }
    return true;
  }

 private:
  /// Extracts the signed number in the lowest bits.
  static std::int8_t number(std::uint32_t word) {
    const auto bits = static_cast<int>(word & 31U);
    return static_cast<std::int8_t>(bits < 16 ? bits : bits - 32);
  }
};

/// Reads AXES, if present: calls set(joint, TurnedAxes) for each joint with turned axes.
template <typename MayTurn, typename Set>
mcpr_result read_turned_axes(const Bytes& axes, int joints, const MayTurn& may_turn,
                             const Set& set) {
  if (axes.data == nullptr) return kOk;
  constexpr const char* kNone = "AXES sets bits that must be zero, or ends early";
  std::size_t candidates = 0;
  for (int j = 0; j < joints; ++j) candidates += may_turn(j) ? 1 : 0;
  Cursor cursor = axes.cursor();
  const std::uint8_t* const flags = cursor.take((candidates + 7) / 8);
  if (cursor.failed()) return failure(MCPR_INVALID, axes.offset, "AXES is too short");
  if (candidates % 8 != 0 && flags[candidates / 8] >> (candidates % 8) != 0)
    return failure(MCPR_INVALID, axes.offset, kNone);
  std::size_t i = 0;
  for (int j = 0; j < joints; ++j) {
    if (!may_turn(j)) continue;
    const bool turned = (flags[i / 8] >> (i % 8) & 1) != 0;
    ++i;
    if (!turned) continue;
    const std::size_t offset = cursor.offset();
    TurnedAxes coded;
    if (!coded.set(cursor.read<std::uint32_t>()) || cursor.failed())
      return failure(MCPR_INVALID, offset, kNone);
    set(j, coded);
  }
  if (!cursor.at_end()) return failure(MCPR_INVALID, cursor.offset(), "AXES has the wrong size");
  return kOk;
}

inline Matrix3 rotation_of(const std::int8_t (&turn)[3]) {
  const Vector3 steps{
      {static_cast<double>(turn[0]), static_cast<double>(turn[1]), static_cast<double>(turn[2])}};
  const double count = norm(steps);
  if (count == 0) return {};
  const auto [sine, cosine] = sine_and_cosine(count * kPi / (2 * kFixedTurns));
  const double part = sine / count;
  return rotation_of(cosine, part * steps[0], part * steps[1], part * steps[2]);
}

inline void turn_axes(const TurnedAxes& turned, JointModel& joint) {
  joint.has_axes = true;
  joint.parent_from_axes = joint.parent_from_axes * rotation_of(turned.before);
  joint.axes_from_joint = rotation_of(turned.after) * joint.axes_from_joint;
}

}  // namespace mocapress::runtime
