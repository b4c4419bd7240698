// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace mocapress::runtime {

/// Reserves space at the end of a block. Without memory it only measures the size of the block.
class BlockLayout {
 public:
  explicit BlockLayout(std::byte* memory) : memory_(memory) {}

  /// Reserves bytes and returns their offset.
  std::uint32_t reserve(std::uint64_t bytes) {
    used_ = (used_ + 7) / 8 * 8;
    const std::uint64_t at = used_;
    used_ += bytes;
    return static_cast<std::uint32_t>(at);
  }

  /// The address of an offset in the block; null when measuring.
  template <typename T>
  T* at(std::uint32_t offset) const {
    return memory_ == nullptr ? nullptr : reinterpret_cast<T*>(memory_ + offset);
  }
  std::uint64_t used() const { return used_; }

 private:
  std::byte* memory_;
  std::uint64_t used_ = 0;
};

}  // namespace mocapress::runtime
