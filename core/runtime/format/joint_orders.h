// SPDX-License-Identifier: MIT
// The rotation order of each joint that turns about three axes. A bank stores the orders per clip,
// so that clips that differ in nothing else share one skeleton: FORMAT.md, "Packed clips". A byte
// holds the orders of three joints.
#pragma once

#include <cstdint>

#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/result.h"
#include "core/runtime/format/section.h"

namespace mocapress::runtime {

inline constexpr int kOrders = 6;
inline constexpr int kOrdersOfByte = 3;

/// The axes of each rotation order, from left to right; 0 1 2 are x y z.
inline constexpr std::uint8_t kAxesOfOrder[kOrders][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                          {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};

/// True if the joint has exactly three rotation channels, about three different axes.
inline bool turns_about_three_axes(const std::uint8_t* kinds, int channels) {
  unsigned axes = 0;
  int turns = 0;
  for (int c = 0; c < channels; ++c)
    if (is_rotation(kinds[c])) {
      axes |= 1U << axis_of(kinds[c]);
      ++turns;
    }
  return turns == 3 && axes == 7;
}

/// Rearranges the three rotation channels of a joint into the given order.
inline void set_order(int order, std::uint8_t* kinds, int channels) {
  const std::uint8_t* axis = kAxesOfOrder[order];
  for (int c = 0; c < channels; ++c)
    if (is_rotation(kinds[c])) kinds[c] = static_cast<std::uint8_t>(3 + *axis++);
}

/// Reads the orders of joints, one after the other.
class JointOrders {
 public:
  explicit JointOrders(const Bytes& bytes) : cursor_(bytes.cursor()) {}

  int next() {
    if (in_byte_ == 0) byte_ = cursor_.read<std::uint8_t>();
    in_byte_ = (in_byte_ + 1) % kOrdersOfByte;
    const int order = byte_ % kOrders;
    byte_ /= kOrders;
    fits_ = fits_ && (in_byte_ != 0 || byte_ == 0);
    return order;
  }

  /// Fails if bytes are left over, or if an order was invalid.
  mcpr_result finish() const {
    const bool all = !cursor_.failed() && cursor_.at_end() && fits_ && byte_ == 0;
    return all ? kOk : failure(MCPR_INVALID, cursor_.offset(), "impossible orders of rotations");
  }

 private:
  Cursor cursor_;
  int in_byte_ = 0;
  int byte_ = 0;
  bool fits_ = true;
};

}  // namespace mocapress::runtime
