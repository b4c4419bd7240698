// SPDX-License-Identifier: MIT
// A file of a few kilobytes can ask for gigabytes: with arrays that inflate, or with a large count
// of frames. Readers check the limit here before they allocate.
#pragma once

#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace mocapress {

inline constexpr std::uint64_t kUsualMemoryLimit = std::uint64_t{2} << 30;

/// Bytes that a value of a motion takes while it is read: in the file's form, and in two clips.
inline constexpr std::uint64_t kBytesOfReadValue = 4 * sizeof(double);

/// The most bytes of memory that the contents of one file may take. The limit is the same for the
/// whole process; a program sets it once, before it reads anything.
std::uint64_t memory_limit();
void set_memory_limit(std::uint64_t bytes);

/// Half of this machine's memory; kUsualMemoryLimit if the system does not tell its size.
std::uint64_t half_of_the_memory();

/// Tells that `bytes` exceed the limit, as the end of a sentence about a file. Unset if they do
/// not.
std::optional<std::string> beyond_memory_limit(std::uint64_t bytes);

/// Throws InputError with the file's name if reading it would take more than the limit.
void require_memory(const std::string& file, std::uint64_t bytes);

/// Throws InputError: reading the file took more memory than the machine has.
[[noreturn]] void throw_out_of_memory(const std::string& file);

/// Returns read(). Turns a failed allocation in it into an InputError with the file's name.
template <typename Read>
auto naming_what_takes_memory(const std::string& file, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(file);
  }
}

}  // namespace mocapress
