// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/section.h"

namespace mocapress::runtime {

/// A joint of a skeleton in a cooked bank: an item of so many of these, then the names.
struct BankJoint {
  std::int32_t parent = -1;  // -1: a root
  std::uint32_t name = 0;    // where it is in the item; it ends with a zero
  float offset[3] = {};      // cm, in the parent's frame
  std::uint32_t has_end_site = 0;
  float end_site[3] = {};  // cm, in the joint's frame
};

/// The item: u32 joints, the joints, the names.
class BankSkeleton {
 public:
  explicit BankSkeleton(const Bytes& item) : item_(item) {
    std::uint32_t joints = 0;
    if (item.size < sizeof joints) return;
    std::memcpy(&joints, item.data, sizeof joints);
    if (joints <= (item.size - sizeof joints) / sizeof(BankJoint)) joints_ = joints;
  }

  std::uint32_t joints() const { return joints_; }

  BankJoint joint(std::uint32_t number) const {
    BankJoint joint;
    std::memcpy(&joint, item_.data + sizeof(std::uint32_t) + sizeof joint * number, sizeof joint);
    return joint;
  }

  /// Null: it does not end within the item.
  const char* name(const BankJoint& joint) const {
    if (joint.name >= item_.size) return nullptr;
    const std::uint8_t* const first = item_.data + joint.name;
    return std::memchr(first, 0, item_.size - joint.name) != nullptr
               ? reinterpret_cast<const char*>(first)
               : nullptr;
  }

 private:
  Bytes item_;
  std::uint32_t joints_ = 0;
};

}  // namespace mocapress::runtime
