// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mocapress {

/// Compresses bytes to a raw DEFLATE stream (RFC 1951) by zlib at its best level.
std::vector<std::byte> deflate_bytes(std::span<const std::byte> bytes);

/// The inverse of deflate_bytes(). Throws FormatError on a damaged stream, on bytes after its end,
/// and on more than `most` unpacked bytes; never allocates much more than that.
std::vector<std::byte> inflate_bytes(std::span<const std::byte> bytes, std::size_t most);

}  // namespace mocapress
