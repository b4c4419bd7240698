// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/runtime/format/joint_model.h"
#include "core/runtime/format/section.h"
#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// A joint of a skeleton in a cooked bank, or in a cooked clip outside of a bank.
struct BankJoint {
  std::int32_t parent = -1;  // -1: a root
  std::uint32_t name = 0;    // offset of the joint's zero-terminated name in the item
  float offset[3] = {};      // cm, in the parent's frame
  std::uint32_t has_end_site = 0;
  float end_site[3] = {};  // cm, in the joint's frame
};

/// A skeleton item: the number of joints as u32, then the joints, then their names.
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

  /// Returns a joint's name; null if it does not end within the item.
  const char* name(const BankJoint& joint) const {
    if (joint.name >= item_.size) return nullptr;
    const std::uint8_t* const first = item_.data + joint.name;
    return std::memchr(first, 0, item_.size - joint.name) != nullptr
               ? reinterpret_cast<const char*>(first)
               : nullptr;
  }

  /// Describes a joint for the C interface. The name must end within the item.
  mcpr_joint described(std::uint32_t number) const {
    const BankJoint made = joint(number);
    mcpr_joint told{};
    told.name = name(made);
    told.parent = made.parent;
    std::memcpy(told.offset, made.offset, sizeof told.offset);
    told.has_end_site = made.has_end_site != 0 ? 1 : 0;
    std::memcpy(told.end_site, made.end_site, sizeof told.end_site);
    return told;
  }

  bool is_sound() const {
    if (joints_ < 1 || joints_ > kMostJoints) return false;
    for (std::uint32_t j = 0; j < joints_; ++j) {
      const BankJoint made = joint(j);
      bool sound =
          made.parent >= -1 && made.parent < static_cast<std::int64_t>(j) && name(made) != nullptr;
      for (int i = 0; i < 3; ++i)
        sound = sound && std::isfinite(made.offset[i]) && std::isfinite(made.end_site[i]);
      if (!sound) return false;
    }
    return true;
  }

 private:
  Bytes item_;
  std::uint32_t joints_ = 0;
};

}  // namespace mocapress::runtime
