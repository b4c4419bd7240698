// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mocapress {

/// A raw DEFLATE stream (RFC 1951) of the bytes, by zlib at its best level.
std::vector<std::byte> deflate_bytes(std::span<const std::byte> bytes);

/// The inverse. Throws FormatError on a damaged stream, on bytes after its end, and where it
/// would give more than `most` bytes; never allocates more than about that.
std::vector<std::byte> inflate_bytes(std::span<const std::byte> bytes, std::size_t most);

}  // namespace mocapress
