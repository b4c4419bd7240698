// SPDX-License-Identifier: MIT
#include "core/codec/format/compressed_clip.h"

#include "core/codec/format/axes_section.h"
#include "core/codec/format/rle16.h"

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

Skeleton CompressedClip::coded_skeleton() const {
  return forms.empty() ? skeleton : with_forms(skeleton, forms);
}

std::size_t CompressedClip::motion_bytes() const {
  return likely_bytes.value_or(motion.size()) + (segments ? segments->section_bytes() : 0) +
         (correction ? correction->section_bytes() : 0) + (ends ? ends->section_bytes() : 0) +
         axes_section_bytes(coded_skeleton());
}

std::size_t CompressedClip::correction_bytes() const {
  if (!correction) return 0;
  if (!uses_rle(coding)) {
    CompressedClip alone;
    alone.skeleton = skeleton;
    std::size_t bytes = motion.size() + correction->section_bytes();
    AdaptiveSegments coded_segments(*this);
    for (int k = segment_layout().count(); k > 0; --k) {
      QuantisedSignals coded = coded_segments.next();
      coded.step_exponent.resize(skeleton.channel_count());
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

std::vector<SignalNeighbours> signal_neighbours(const CompressedClip& clip) {
  std::vector<SignalNeighbours> neighbours = channel_neighbours(clip.skeleton);
  if (clip.correction) append_correction_neighbours(clip.correction->signal_count(), neighbours);
  return neighbours;
}

AdaptiveSegments::AdaptiveSegments(const CompressedClip& clip)
    : clip_(clip), neighbours_(signal_neighbours(clip)) {}

std::size_t AdaptiveSegments::size() const {
  return clip_.segments ? clip_.segments->bytes[segment_] : clip_.motion.size();
}

QuantisedSignals AdaptiveSegments::next() {
  if (clip_.known) return clip_.known->coded();
  const std::span bytes = std::span(clip_.motion).subspan(first_byte_, size());
  QuantisedSignals coded =
      adaptive_decode(bytes, neighbours_, clip_.segment_layout().frames_of(segment_), first_byte_,
                      {}, clip_.bands_left_out);
  skip();
  return coded;
}

void AdaptiveSegments::skip() {
  first_byte_ += size();
  ++segment_;
}

std::vector<std::byte> pack_adaptive(const QuantisedSignals& coded, const CompressedClip& clip) {
  return adaptive_encode(coded, signal_neighbours(clip));
}

void set_motion(QuantisedSignals coded, CompressedClip& clip) {
  set_motion(std::make_shared<const KnownMotion>(std::move(coded)), clip);
}

void set_motion(std::shared_ptr<const KnownMotion> coded, CompressedClip& clip) {
  clip.motion = pack_adaptive(coded->coded(), clip);
  clip.known = std::move(coded);
}

void code_motion(CompressedClip& clip) {
  clip.motion = pack_adaptive(clip.known->coded(), clip);
  clip.likely_bytes.reset();
  clip.known.reset();
}

}  // namespace mocapress
