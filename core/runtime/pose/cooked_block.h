// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/runtime/pose/cooked_clip.h"

namespace mocapress::runtime {

/// Reserves space at the end of a cooked clip. Without memory it only counts.
class CookedBlock {
 public:
  explicit CookedBlock(std::byte* memory) : memory_(memory) {}

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
  template <typename T>
  T* reserve_for(std::uint64_t count, TableOffset& offset, std::uint64_t alignment = alignof(T)) {
    return reserve_for<T>(count, offset.bytes, alignment);
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

}  // namespace mocapress::runtime
