// SPDX-License-Identifier: MIT
#include "core/base/memory_limit.h"

#include <atomic>

#include "core/base/error.h"
#include "core/base/machine.h"

namespace mocapress {
namespace {

std::atomic<std::uint64_t> limit = kUsualMemoryLimit;

/// Bytes as text in MiB, rounded up.
std::string size_text(std::uint64_t bytes) {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20;
  return std::to_string(bytes / kMebibyte + (bytes % kMebibyte > 0 ? 1 : 0)) + " MiB";
}

}  // namespace

std::uint64_t memory_limit() {
  return limit;
}

void set_memory_limit(std::uint64_t bytes) {
  limit = bytes;
}

std::uint64_t half_of_the_memory() {
  const std::uint64_t all = physical_memory();
  return all == 0 ? kUsualMemoryLimit : all / 2;
}

std::optional<std::string> beyond_memory_limit(std::uint64_t bytes) {
  if (bytes <= memory_limit()) return std::nullopt;
  return "takes some " + size_text(bytes) + " of memory, but the limit (--memory) is " +
         size_text(memory_limit());
}

void require_memory(const std::string& file, std::uint64_t bytes) {
  if (const auto why = beyond_memory_limit(bytes)) throw InputError(file, 0, 0, *why);
}

void throw_out_of_memory(const std::string& file) {
  throw InputError(file, 0, 0, "takes more memory than this machine has to give");
}

}  // namespace mocapress
