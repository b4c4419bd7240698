// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/format/result.h"

namespace mocapress::runtime {

inline constexpr std::size_t kAlignment = 32;  // equals MCPR_ALIGNMENT

/// Allocates pieces from the caller's memory. A measuring instance has no memory and only counts,
/// so that one function serves both to measure and to lay out.
class Memory {
 public:
  Memory() = default;  // a measuring instance
  Memory(void* memory, std::size_t size) : base_(static_cast<std::byte*>(memory)), size_(size) {}

  /// Returns uninitialised memory; null when measuring or when too little is left.
  template <typename T>
  T* take(std::uint64_t count) {
    const std::uint64_t bytes = (count * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
    const std::uint64_t at = used_;
    used_ += bytes;
    if (base_ == nullptr || used_ > size_) return nullptr;
    return reinterpret_cast<T*>(base_ + at);
  }

  std::uint64_t used() const { return used_; }

  /// True if all that was taken so far fits into the memory, and the memory is aligned.
  bool holds() const {
    return base_ != nullptr && used_ <= size_ &&
           reinterpret_cast<std::uintptr_t>(base_) % kAlignment == 0;
  }

 private:
  std::byte* base_ = nullptr;
  std::size_t size_ = 0;
  std::uint64_t used_ = 0;
};

/// Succeeds if memory from the caller is aligned and can hold `needed` bytes. `too_small` is the
/// message if the memory is too small.
inline mcpr_result check_memory(const void* memory, std::size_t size, std::uint64_t needed,
                                const char* too_small) {
  if (memory == nullptr) return failure(MCPR_NO_MEMORY, 0, "no memory was given");
  if (reinterpret_cast<std::uintptr_t>(memory) % kAlignment != 0)
    return failure(MCPR_MISALIGNED, 0, "the memory is not aligned to MCPR_ALIGNMENT");
  return size < needed ? failure(MCPR_MEMORY, 0, too_small) : kOk;
}

}  // namespace mocapress::runtime
