// SPDX-License-Identifier: MIT
// A file of some kilobytes can ask for gigabytes: arrays that inflate, frames that are only
// counted. Readers ask here before they take what a file asks for.
#pragma once

#include <cstdint>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace mocapress {

inline constexpr std::uint64_t kUsualMemoryLimit = std::uint64_t{2} << 30;

/// A motion's value takes so much while it is read: as it stands in the file, and in two clips.
inline constexpr std::uint64_t kBytesOfReadValue = 4 * sizeof(double);

/// The most memory that the contents of one file may take, in bytes, for the whole process. A
/// program sets it once, before it reads anything.
std::uint64_t memory_limit();
void set_memory_limit(std::uint64_t bytes);

/// Half of the memory that this machine has.
std::uint64_t half_of_the_memory();

/// Why so many bytes are too many, as what a sentence says of a file; none where they are not.
std::optional<std::string> beyond_memory_limit(std::uint64_t bytes);

/// Throws InputError, which names the file, where reading it would take more than the limit.
void require_memory(const std::string& file, std::uint64_t bytes);

/// The InputError for a file for which the machine itself had too little memory.
[[noreturn]] void throw_out_of_memory(const std::string& file);

/// Returns what `read` does. A failing allocation in it becomes an InputError that names the file.
template <typename Read>
auto naming_what_takes_memory(const std::string& file, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(file);
  }
}

}  // namespace mocapress
