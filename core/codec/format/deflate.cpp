// SPDX-License-Identifier: MIT
#include "core/codec/format/deflate.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "core/base/error.h"

namespace mocapress {
namespace {

constexpr int kRawWindowBits = -15;  // no zlib header: the container has its own checksum

Bytef* writable(std::byte* bytes) {
  return reinterpret_cast<Bytef*>(bytes);
}
Bytef* input(const std::byte* bytes) {
  return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes));  // zlib does not write to it
}

}  // namespace

std::vector<std::byte> deflate_bytes(std::span<const std::byte> bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRawWindowBits, 9,
                   Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  std::vector<std::byte> packed(deflateBound(&stream, static_cast<uLong>(bytes.size())));
  stream.next_in = input(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = writable(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const int status = deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (status != Z_STREAM_END) throw std::logic_error("deflate did not finish in its own bound");
  return packed;
}

std::vector<std::byte> inflate_bytes(std::span<const std::byte> bytes, std::size_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, kRawWindowBits) != Z_OK) throw std::bad_alloc();
  stream.next_in = input(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::vector<std::byte> unpacked;
  std::array<std::byte, 16384> part;
  int status = Z_OK;
  // Inflates up to one byte beyond the limit, which tells that there are too many.
  while (status == Z_OK && unpacked.size() <= most) {
    const std::size_t room = std::min(part.size(), most + 1 - unpacked.size());
    stream.next_out = writable(part.data());
    stream.avail_out = static_cast<uInt>(room);
    status = inflate(&stream, Z_NO_FLUSH);
    unpacked.insert(unpacked.end(), part.data(), part.data() + (room - stream.avail_out));
  }
  const std::size_t consumed = bytes.size() - stream.avail_in;
  inflateEnd(&stream);
  if (unpacked.size() > most) throw FormatError(consumed, "inflates to more bytes than allowed");
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != Z_STREAM_END) throw FormatError(consumed, "the DEFLATE stream is damaged");
  if (consumed != bytes.size()) throw FormatError(consumed, "bytes after the DEFLATE stream");
  return unpacked;
}

}  // namespace mocapress
