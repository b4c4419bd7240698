// SPDX-License-Identifier: MIT
#include "core/codec/compressed_clip.h"

#include "core/codec/rle16.h"

namespace mocapress {

std::string_view name(Method method) {
  switch (method) {
    case Method::PerChannel:
      return "per-channel";
    case Method::Standard:
      return "standard";
    case Method::Annealed:
      return "annealed";
  }
  return "unknown";
}

std::size_t CompressedClip::correction_bytes() const {
  if (!correction) return 0;
  std::vector<std::byte> words = unpack_motion(*this);
  ByteReader reader(words);
  rle16_decode(reader, frames, skeleton.channel_count());
  words.resize(reader.offset());
  return motion_bytes() - pack(words, coding).size();
}

std::vector<std::byte> unpack_motion(const CompressedClip& clip) {
  const int channels = clip.skeleton.channel_count();
  std::size_t most = rle16_bound(clip.frames, channels);
  if (clip.correction) most += rle16_bound(clip.frames, clip.correction->signal_count());
  return unpack(clip.motion, clip.coding, most);
}

}  // namespace mocapress
