// SPDX-License-Identifier: MIT
#include "core/codec/compressed_clip.h"

#include <numeric>

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
    case Method::ClosedLoop:
      return "closed-loop";
  }
  return "unknown";
}

std::size_t CompressedClip::correction_bytes() const {
  if (!correction) return 0;
  if (!is_of_words(coding)) {
    CompressedClip alone;
    alone.skeleton = skeleton;
    std::size_t bytes = motion.size() + correction->section_bytes();
    for (int k = 0; k < segment_layout().count(); ++k) {
      QuantisedSignals coded = unpack_adaptive(*this, k);
      coded.fineness.resize(static_cast<std::size_t>(skeleton.channel_count()));
      coded.values = coded.values.leftCols(skeleton.channel_count()).eval();
      bytes -= pack_adaptive(coded, alone).size();
    }
    return bytes;
  }
  std::vector<std::byte> words = unpack_motion(*this);
  ByteReader reader(words);
  rle16_read(reader, frames, skeleton.channel_count());
  words.resize(reader.offset());
  return motion_bytes() - pack(words, coding).size();
}

std::vector<std::byte> unpack_motion(const CompressedClip& clip) {
  const int channels = clip.skeleton.channel_count();
  std::size_t most = rle16_bound(clip.frames, channels);
  if (clip.correction) most += rle16_bound(clip.frames, clip.correction->signal_count());
  return unpack(clip.motion, clip.coding, most);
}

namespace {

std::vector<SignalKin> kin_of(const CompressedClip& clip) {
  std::vector<SignalKin> kin = channel_kin(clip.skeleton);
  if (clip.correction) append_correction_kin(clip.correction->signal_count(), kin);
  return kin;
}

}  // namespace

QuantisedSignals unpack_adaptive(const CompressedClip& clip, int segment) {
  const SegmentLayout layout = clip.segment_layout();
  std::span<const std::byte> bytes = clip.motion;
  std::size_t offset = 0;
  if (clip.segments) {
    const auto& sizes = clip.segments->bytes;
    offset = std::accumulate(sizes.begin(), sizes.begin() + segment, std::size_t{0});
    bytes = bytes.subspan(offset, sizes[static_cast<std::size_t>(segment)]);
  }
  return adaptive_decode(bytes, kin_of(clip), layout.frames_of(segment), offset);
}

std::vector<std::byte> pack_adaptive(const QuantisedSignals& coded, const CompressedClip& clip) {
  return adaptive_encode(coded, kin_of(clip));
}

}  // namespace mocapress
