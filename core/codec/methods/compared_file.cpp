// SPDX-License-Identifier: MIT
#include "core/codec/methods/compared_file.h"

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/memory_limit.h"
#include "core/base/utf8_path.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"

namespace mocapress {

std::vector<std::byte> write_compared(const ComparisonMethod& method, const CompressedClip& clip) {
  ByteWriter payload;
  payload.write_short_string(std::string(method.name));
  payload.append(clip.motion);
  Container container{clip, true};
  container.clip.motion = payload.release();
  return write_container(container);
}

namespace {

constexpr std::size_t kStartOfFile = 0;

// Measured: a value takes 48 to 50 bytes of memory while it is decoded and written as BVH. Motion
// in DEFLATE (coding.h) may take another 12 while its 16-bit words are inflated.
constexpr std::uint64_t kBytesOfValue = 64;

}  // namespace

OpenedMcpr read_coded_mcpr(std::span<const std::byte> bytes) {
  Container container = read_any_container(bytes);
  OpenedMcpr opened{.compressed = std::move(container.clip), .decoded = {}};
  CompressedClip& clip = opened.compressed;
  if (!container.of_comparison) {
    opened.method = wavelet_method_name(clip);
    return opened;
  }
  ByteReader payload(clip.motion);
  opened.of_wavelets = false;
  opened.method = payload.read_short_string();
  if (find_comparison_method(opened.method) == nullptr)
    payload.fail("unknown method of compression: " + opened.method);
  const auto motion = payload.take(payload.remaining());
  clip.motion = {motion.begin(), motion.end()};
  return opened;
}

Clip decode(const OpenedMcpr& opened) {
  const CompressedClip& clip = opened.compressed;
  if (opened.of_wavelets) return decode(clip);
  return find_comparison_method(opened.method)
      ->decode(clip.skeleton, clip.sample_rate_hz, clip.frames, clip.motion);
}

OpenedMcpr read_mcpr(std::span<const std::byte> bytes) {
  OpenedMcpr opened = read_coded_mcpr(bytes);
  if (const auto why = beyond_memory_limit(kBytesOfValue * sections_of(bytes).room_values()))
    throw FormatError(kStartOfFile, *why);
  opened.decoded = decode(opened);
  if (!opened.decoded.channels.allFinite())
    throw FormatError(sections_of(bytes).motion.offset,
                      "the motion has values that are not finite");
  return opened;
}

OpenedMcpr open_mcpr(const std::filesystem::path& path) {
  try {
    return naming_what_takes_memory(utf8(path), [&] { return read_mcpr(read_bytes(path)); });
  } catch (const FormatError& error) {
    throw InputError(utf8(path), 0, 0, error.what());
  }
}

std::string_view wavelet_method_name(const CompressedClip& wavelets) {
  const Method method = wavelets.provenance.method;
  return method == Method::Standard && wavelets.basis != Basis::Cubic ? name(wavelets.basis)
                                                                      : name(method);
}

}  // namespace mocapress
