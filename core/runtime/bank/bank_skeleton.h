// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/section.h"

namespace mocapress::runtime {

/// A joint of a skeleton in a cooked bank.
struct BankJoint {
  std::int32_t parent = -1;  // -1: a root
  std::uint32_t name = 0;    // offset in the item of the zero-terminated name
  float offset[3] = {};      // cm, in the parent's frame
  std::uint32_t has_end_site = 0;
  float end_site[3] = {};  // cm, in the joint's frame
};

/// A skeleton item: u32 number of joints, the joints, their names.
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

  /// Null if the name does not end within the item.
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
