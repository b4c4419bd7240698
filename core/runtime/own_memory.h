// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

#include "core/runtime/format/memory.h"

namespace mocapress {

/// Aligned memory for objects of the decoder, which never allocate memory themselves.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::size_t size) : size_(size), bytes_(allocate(size)) {}

  std::byte* data() const { return bytes_.get(); }
  std::size_t size() const { return size_; }

 private:
  static constexpr auto kAlignment = static_cast<std::align_val_t>(runtime::kAlignment);
  struct Free {
    void operator()(std::byte* bytes) const { ::operator delete(bytes, kAlignment); }
  };
  static std::byte* allocate(std::size_t size) {
    return static_cast<std::byte*>(::operator new(size, kAlignment));
  }

  std::size_t size_;
  std::unique_ptr<std::byte, Free> bytes_;
};

/// Owns an object of the decoder, constructed as Part(memory, arguments...), together with its
/// memory.
template <typename Part>
class OwnMemory {
 public:
  template <typename... Arguments>
  explicit OwnMemory(const Arguments&... arguments)
      : bytes_(need(arguments...)),
        memory_(bytes_.data(), bytes_.size()),
        part_(memory_, arguments...) {}
  OwnMemory(const OwnMemory&) = delete;
  OwnMemory& operator=(const OwnMemory&) = delete;

  const Part& operator*() const { return part_; }
  Part& operator*() { return part_; }
  Part* operator->() { return &part_; }

 private:
  template <typename... Arguments>
  static std::size_t need(const Arguments&... arguments) {
    runtime::Memory measuring;
    Part(measuring, arguments...);
    return static_cast<std::size_t>(measuring.used());
  }

  AlignedBytes bytes_;
  runtime::Memory memory_;
  Part part_;
};

}  // namespace mocapress
