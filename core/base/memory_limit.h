// SPDX-License-Identifier: MIT
// A file of some kilobytes can ask for gigabytes: arrays that inflate, frames that are only
// counted. Readers ask here before they allocate.
#pragma once

#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace mocapress {

inline constexpr std::uint64_t kUsualMemoryLimit = std::uint64_t{2} << 30;

/// Bytes for a motion's value while it is read: as in the file, and in two clips.
inline constexpr std::uint64_t kBytesOfReadValue = 4 * sizeof(double);

/// The most memory that the contents of one file may take, in bytes, for the whole process. A
/// program sets it once, before it reads anything.
std::uint64_t memory_limit();
void set_memory_limit(std::uint64_t bytes);

/// Half of this machine's memory.
std::uint64_t half_of_the_memory();

/// Why `bytes` are beyond the limit, as the end of a sentence about a file; unset if they are not.
std::optional<std::string> beyond_memory_limit(std::uint64_t bytes);

/// Throws InputError with the file's name if reading it would take more than the limit.
void require_memory(const std::string& file, std::uint64_t bytes);

/// Throws the InputError for a file that exceeded the machine's own memory.
[[noreturn]] void throw_out_of_memory(const std::string& file);

/// Returns read(). A failed allocation in it becomes an InputError with the file's name.
template <typename Read>
auto naming_what_takes_memory(const std::string& file, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(file);
  }
}

}  // namespace mocapress
