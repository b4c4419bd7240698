// SPDX-License-Identifier: MIT
#include "core/runtime/format/file_sections.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/runtime/format/cursor.h"
#include "core/runtime/format/end_poses.h"
#include "core/runtime/format/format_limits.h"

namespace mocapress::runtime {
namespace {

class SectionsReader {
 public:
  SectionsReader(const mcpr_limits& limits, FileSections& sections)
      : limits_(limits), sections_(sections) {}

  mcpr_result read(Cursor file) {
    known_bytes_ = kFileHead;
    std::uint16_t count = 0;
    if (const mcpr_result result = read_head(file, count); failed(result)) return result;
    for (int left = count; left > 0; --left) {
      Section section;
      mcpr_result result = read_section(file, section);
      if (!failed(result)) result = take_counted(section);
      if (failed(result)) return result;
    }
    if (const mcpr_result result = take_pieces(file); failed(result)) return result;
    const bool may_end_here = wanted_tiers() < sections_.tiers.count;
    return check_end(file.offset(), may_end_here ? 0 : file.left());
  }

  mcpr_result read(PackedSections packed) {
    std::uint16_t count = 0;
    if (const mcpr_result result = packed.begin(count); failed(result)) return result;
    is_packed_ = true;
    tiers_present_ = packed.tiers();
    sections_.joint_orders = packed.orders();
    known_bytes_ = kFileHead + (packed.orders().size > 0 ? kReorderedRoom : 0);
    for (int left = count; left > 0; --left) {
      Section section;
      mcpr_result result = packed.next(section);
      if (!failed(result) && section.is(kLearned)) {
        result = keep(section.payload, sections_.learned);
        known_bytes_ += kSectionHead + section.payload.size;
      } else if (!failed(result)) {
        result = take_counted(section);
      }
      if (failed(result)) return result;
    }
    if (const mcpr_result result = take_pieces(packed); failed(result)) return result;
    return check_end(packed.offset(), packed.left());
  }

 private:
  mcpr_result check_end(std::size_t offset, std::size_t bytes_left) {
    if (next_ < Expected::Correction) return failure(MCPR_INVALID, offset, "a section is missing");
    if (bytes_left > 0) return failure(MCPR_INVALID, offset, "bytes after the last section");
    if (const mcpr_result result = check_tiers(offset); failed(result)) return result;
    if (tracks_.data != nullptr)
      if (const mcpr_result result = read_tracks(tracks_); failed(result)) return result;
    return check_room();
  }

  /// Reads a section. Its size counts in known_bytes_, unless it is TIER or unknown.
  mcpr_result take_counted(const Section& section) {
    is_skipped_ = false;
    const mcpr_result result = take(section);
    if (!is_skipped_) known_bytes_ += kSectionHead + section.payload.size;
    return result;
  }

  /// Adds the next tier's piece to the motion.
  mcpr_result take_piece(const Bytes& piece) {
    if (sections_.tiers_read == 0)
      return failure(MCPR_INVALID, piece.offset, "a finer tier without MOTN");
    known_bytes_ += piece.size;
    sections_.fine[sections_.tiers_read++ - 1] = piece;
    return check_segment_sizes();
  }

  /// Reads the pieces of the wanted tiers, which follow the sections in a file.
  mcpr_result take_pieces(Cursor& file) {
    const TierTable& tiers = sections_.tiers;
    if (tiers.count > 0 && file.offset() != tiers.file_bytes(0))
      return failure(MCPR_INVALID, file.offset(), "the first tier does not end where TIER says");
    for (int t = 1; t < wanted_tiers(); ++t) {
      Bytes piece{nullptr, tiers.tier[t].bytes, file.offset()};
      piece.data = file.take(piece.size);
      if (file.failed()) return failure(MCPR_DAMAGED, piece.offset, "the file ends within a tier");
      if (crc32(piece.data, piece.size) != tiers.tier[t].checksum)
        return failure(MCPR_DAMAGED, piece.offset, "a tier is damaged: its checksum differs");
      if (const mcpr_result result = take_piece(piece); failed(result)) return result;
    }
    return kOk;
  }

  /// Reads the pieces of the wanted tiers of a packed clip, which its bank stores.
  mcpr_result take_pieces(const PackedSections& packed) {
    for (int t = 1; t < wanted_tiers(); ++t)
      if (const mcpr_result result = take_piece(packed.piece(t)); failed(result)) return result;
    return kOk;
  }

  /// Number of tiers to read; 0 if the clip has no tiers.
  int wanted_tiers() const {
    const auto count = static_cast<std::uint32_t>(std::min(sections_.tiers.count, tiers_present_));
    return static_cast<int>(limits_.tiers == 0 ? count : std::min(limits_.tiers, count));
  }

  /// Checks that all wanted tiers were read. Drops the end corrections if the finest bands are
  /// missing.
  mcpr_result check_tiers(std::size_t offset) {
    if (sections_.tiers_read != wanted_tiers())
      return failure(MCPR_INVALID, offset, "a tier is missing");
    if (sections_.bands_left_out() > 0) {
      sections_.ends_bytes = 0;
      sections_.end_reaches = {};
    }
    return kOk;
  }

  enum class Expected { Joints, Clip, Segments, Motion, Correction, Ends, Axes, Nothing };

  /// Reads a section. Required sections come in a fixed order; optional ones may come anywhere.
  mcpr_result take(const Section& section) {
    if (next_ == Expected::Joints && section.is("TIER") && sections_.tiers.count == 0 &&
        sections_.learned.data == nullptr) {
      is_skipped_ = true;  // the limits are those of the same file without tiers, so TIER does not
                           // count
      return read_tiers(section.payload, sections_.tiers, is_packed_);
    }
    if (next_ == Expected::Joints && section.is("JNTS")) {
      next_ = Expected::Clip;
      return read_joints(section.payload);
    }
    if (next_ == Expected::Clip && section.is("CLIP")) {
      next_ = Expected::Segments;
      return read_clip(section.payload);
    }
    const bool adaptive = sections_.is_adaptive();
    if (next_ == Expected::Segments && adaptive && section.is("SEGS")) {
      next_ = Expected::Motion;
      return read_segments(section.payload);
    }
    const bool wavelets = sections_.coding != kComparison;
    if ((next_ == Expected::Segments || next_ == Expected::Motion) &&
        section.is(wavelets ? "MOTN" : "COMP")) {
      next_ = Expected::Correction;
      sections_.motion = section.payload;
      if (sections_.tiers.count > 0) {
        if (!adaptive) return failure(MCPR_INVALID, section.start, "tiers of another coding");
        sections_.tiers_read = 1;
      }
      return check_segment_sizes();
    }
    if (next_ == Expected::Correction && wavelets && section.is("IKCO")) {
      next_ = Expected::Ends;
      return read_correction(section.payload);
    }
    if ((next_ == Expected::Correction || next_ == Expected::Ends) && adaptive &&
        section.is("ENDS")) {
      next_ = Expected::Axes;
      return runtime::read_ends(section.payload, sections_);
    }
    if (next_ >= Expected::Correction && next_ <= Expected::Axes && adaptive &&
        section.is("AXES")) {
      next_ = Expected::Nothing;
      sections_.axes = section.payload;
      return kOk;
    }
    if (section.is("loop")) return read_loop(section.payload);
    if (section.is("ordr")) return keep(section.payload, sections_.orders);
    if (section.is("srce")) return keep(section.payload, sections_.source);
    if (section.is("trks")) return keep(section.payload, tracks_);
    if (!section.is_optional())
      return failure(MCPR_INVALID, section.start, "a section that is not expected here");
    is_skipped_ = true;
    return kOk;
  }

  static mcpr_result keep(const Bytes& payload, Bytes& place) {
    if (place.data != nullptr)
      return failure(MCPR_INVALID, payload.offset, "a section for the second time");
    place = payload;
    return kOk;
  }

  mcpr_result read_joints(const Bytes& payload) {
    Cursor cursor(payload.data, payload.size, payload.offset);
    sections_.joint_bytes = cursor.read<std::uint32_t>();
    sections_.joints = cursor.read<std::uint16_t>();
    sections_.channels = cursor.read<std::uint16_t>();
    if (cursor.failed()) return failure(MCPR_INVALID, cursor.offset(), "JNTS is too short");
    if (sections_.joints == 0 || sections_.joints > kMostJoints ||
        sections_.joint_bytes > kMostBytesOfJoint * sections_.joints ||
        sections_.channels > kMostChannelsOfJoint * sections_.joints)
      return failure(MCPR_INVALID, payload.offset, "the skeleton has an impossible size");
    if (sections_.joints > limits_.joints || sections_.channels > limits_.channels)
      return failure(MCPR_LIMIT, payload.offset, "more joints or channels than the limits allow");
    const std::size_t size = cursor.left();
    sections_.coded_joints = {cursor.take(size), size, payload.offset + 8};
    return kOk;
  }

  mcpr_result read_clip(const Bytes& payload) {
    constexpr std::size_t kSize = 8 + 4 + 4 + 8 + 4 + 4;
    if (payload.size != kSize)
      return failure(MCPR_INVALID, payload.offset, "CLIP has the wrong size");
    Cursor cursor(payload.data, payload.size, payload.offset);
    sections_.sample_rate = cursor.read<double>();
    if (!std::isfinite(sections_.sample_rate) || sections_.sample_rate <= 0)
      return failure(MCPR_INVALID, payload.offset, "the sample rate is not a positive number");
    sections_.frames = cursor.read<std::uint32_t>();
    const std::size_t at = cursor.offset();
    const auto basis = cursor.read<std::uint8_t>();
    const auto coding = cursor.read<std::uint8_t>();
    const auto method = cursor.read<std::uint8_t>();
    const auto weighting = cursor.read<std::uint8_t>();
    if (sections_.frames > kMostFrames)
      return failure(MCPR_INVALID, at - 4, "more than 2^22 frames");
    if (basis > 2) return failure(MCPR_INVALID, at, "unknown basis");
    if (coding > kAdaptive) return failure(MCPR_INVALID, at + 1, "unknown coding");
    if (coding == kComparison && basis != static_cast<std::uint8_t>(Wavelet::Haar))
      return failure(MCPR_INVALID, at, "a basis where there are no wavelets");
    if ((method == 0) != (coding == kComparison) || method > 4)
      return failure(MCPR_INVALID, at + 2, "unknown method");
    if (weighting > 4) return failure(MCPR_INVALID, at + 3, "unknown weighting");
    if (sections_.frames > limits_.frames)
      return failure(MCPR_LIMIT, at - 4, "more frames than the limits allow");
    sections_.wavelet = static_cast<Wavelet>(basis);
    sections_.coding = coding;
    sections_.method = method;
    sections_.weighting = weighting;
    sections_.seed = cursor.read<std::uint64_t>();
    sections_.eps_cm = cursor.read<float>();
    sections_.max_error_cm = cursor.read<float>();
    if (sections_.tiers.count > 0) {
      Tier& last = sections_.tiers.tier[sections_.tiers.count - 1];
      last.eps_cm = sections_.eps_cm;
      last.max_error_cm = sections_.max_error_cm;
    }
    sections_.segments = SegmentLayout::whole(static_cast<int>(sections_.frames));
    return check_values(at - 4);
  }

  mcpr_result read_segments(const Bytes& payload) {
    Cursor cursor(payload.data, payload.size, payload.offset);
    const auto length = cursor.read<std::uint32_t>();
    const auto overlap = cursor.read<std::uint32_t>();
    const auto count = cursor.read<std::uint32_t>();
    if (cursor.failed()) return failure(MCPR_INVALID, payload.offset, "SEGS is too short");
    if (!may_be_segments(sections_.frames, length, overlap))
      return failure(MCPR_INVALID, payload.offset, "the segments have an impossible length");
    sections_.segments.length = static_cast<int>(length);
    sections_.segments.overlap = static_cast<int>(overlap);
    if (count != static_cast<std::uint32_t>(sections_.segments.count()))
      return failure(MCPR_INVALID, payload.offset + 8,
                     "the number of segments does not fit the frames");
    const std::size_t offset = cursor.offset();
    const std::size_t size =
        4 * std::size_t{count} * static_cast<std::size_t>(std::max(sections_.tiers.count, 1));
    if (cursor.left() != size) return failure(MCPR_INVALID, offset, "SEGS has the wrong size");
    sections_.segment_sizes = {cursor.take(size), size, offset};
    sections_.segments_bytes = payload.size;
    return check_values(payload.offset);
  }

  /// Checks that the sizes of the segments add up to the size of the last piece that was read.
  mcpr_result check_segment_sizes() const {
    if (sections_.segments_bytes == 0) return kOk;
    const int piece = std::max(sections_.tiers_read - 1, 0);
    std::uint64_t sum = 0;
    for (int k = 0; k < sections_.segments.count(); ++k) sum += sections_.segment_size(piece, k);
    if (sum != sections_.piece(piece).size)
      return failure(MCPR_INVALID, sections_.segment_sizes.offset,
                     "the sizes of the segments do not add up to MOTN or to a finer tier");
    return kOk;
  }

  /// Bounds the decoded size, and so the time that decoding takes, by the size of the file:
  /// FORMAT.md, Limits.
  mcpr_result check_room() const {
    if (sections_.room_values() > most_values_of(known_bytes_))
      return failure(MCPR_INVALID, sections_.motion.offset,
                     "too many samples for so few coded bytes");
    return kOk;
  }

  mcpr_result check_values(std::size_t offset) const {
    if (sections_.value_count() > kMostValues)
      return failure(MCPR_INVALID, offset, "more than 2^26 values");
    if (sections_.value_count() > limits_.values)
      return failure(MCPR_LIMIT, offset, "more values than the limits allow");
    return kOk;
  }

  mcpr_result read_tracks(const Bytes& payload) {
    constexpr std::uint32_t kMostRecord = 2 * (1 + 255) + 2;
    Cursor cursor = payload.cursor();
    TracksHead& head = sections_.tracks;
    head.tracks = cursor.read<std::uint16_t>();
    head.curves = cursor.read<std::uint16_t>();
    const auto wavelet = cursor.read<std::uint8_t>();
    head.record_bytes = cursor.read<std::uint32_t>();
    head.runs = cursor.read<std::uint32_t>();
    const auto stream_bytes = cursor.read<std::uint32_t>();
    const std::size_t stream_offset = cursor.offset();
    head.stream = {cursor.take(stream_bytes), stream_bytes, stream_offset};
    if (cursor.failed()) return failure(MCPR_INVALID, payload.offset, "trks is too short");
    if (sections_.frames == 0 || head.tracks == 0 || head.tracks > kMostTracks ||
        head.curves > head.tracks || head.record_bytes > kMostRecord * head.tracks ||
        head.runs > std::uint64_t{head.tracks - head.curves} * sections_.frames)
      return failure(MCPR_INVALID, payload.offset, "the tracks have an impossible size");
    if (wavelet > 2) return failure(MCPR_INVALID, payload.offset + 4, "unknown basis of tracks");
    if (head.curves == 0 && stream_bytes > 0)
      return failure(MCPR_INVALID, stream_offset, "bytes of curves where there are none");
    head.wavelet = static_cast<Wavelet>(wavelet);
    const std::size_t offset = cursor.offset();
    const std::size_t size = cursor.left();
    head.bits = {cursor.take(size), size, offset};
    head.bytes = kSectionHead + payload.size;
    head.payload = payload;
    return check_values(payload.offset);
  }

  mcpr_result read_correction(const Bytes& payload) {
    Cursor cursor(payload.data, payload.size, payload.offset);
    const auto solver = cursor.read<std::uint8_t>();
    const auto effectors = cursor.read<std::uint8_t>();
    if (solver < 1 || solver > 2) return failure(MCPR_INVALID, payload.offset, "unknown solver");
    if (effectors < 1 || effectors > kMostEffectors || payload.size != 2U + 4U * effectors)
      return failure(MCPR_INVALID, payload.offset + 1, "IKCO has the wrong size");
    sections_.solver = static_cast<Solver>(solver);
    sections_.effectors = effectors;
    sections_.correction_bytes = payload.size;
    sections_.effector_offset = cursor.offset();
    for (int e = 0; e < effectors; ++e) {
      const auto joint = cursor.read<std::uint16_t>();
      sections_.effector[e] = {joint, cursor.read<std::uint16_t>()};
      if (sections_.effector[e].joint >= sections_.joints ||
          sections_.effector[e].top >= sections_.joints)
        return failure(MCPR_INVALID, cursor.offset() - 4, "an effector is not a joint");
    }
    return check_values(payload.offset + 1);
  }

  mcpr_result read_loop(const Bytes& payload) {
    if (sections_.loop != LoopKind::None)
      return failure(MCPR_INVALID, payload.offset, "a second section loop");
    if (payload.size != 1 || payload.data[0] < 1 || payload.data[0] > 2)
      return failure(MCPR_INVALID, payload.offset, "unknown kind of loop");
    sections_.loop = static_cast<LoopKind>(payload.data[0]);
    return kOk;
  }

  const mcpr_limits& limits_;
  FileSections& sections_;
  std::size_t known_bytes_ = 0;
  bool is_skipped_ = false;  // the last section does not count in known_bytes_
  bool is_packed_ = false;
  int tiers_present_ =
      kMostTiers;  // most tiers that can be read; fewer if the bank of a packed clip was cut
  Bytes tracks_;   // payload of trks, which may come before CLIP but is read after it
  Expected next_ = Expected::Joints;
};

}  // namespace

std::uint32_t FileSections::segment_size(int piece_number, int segment) const {
  if (segments_bytes == 0) return static_cast<std::uint32_t>(piece(piece_number).size);
  std::uint32_t size = 0;
  const auto place = static_cast<std::size_t>(piece_number * segments.count() + segment);
  std::memcpy(&size, segment_sizes.data + sizeof size * place, sizeof size);
  return size;
}

std::uint32_t FileSections::segment_size(int segment) const {
  std::uint32_t size = 0;
  for (int p = 0; p < pieces(); ++p) size += segment_size(p, segment);
  return size;
}

std::size_t FileSections::offset_of(int segment, std::size_t byte) const {
  int p = 0;
  while (p + 1 < pieces() && byte >= segment_size(p, segment)) byte -= segment_size(p++, segment);
  for (int k = 0; k < segment; ++k) byte += segment_size(p, k);
  return piece(p).offset + byte;
}

void FileSections::copy_coded(std::uint8_t* out) const {
  std::size_t first[kMostTiers] = {};  // position of the next segment in each piece
  for (int k = 0; k < segments.count(); ++k)
    for (int p = 0; p < pieces(); ++p) {
      const std::size_t size = segment_size(p, k);
      if (size > 0) std::memcpy(out, piece(p).data + first[p], size);
      out += size;
      first[p] += size;
    }
}

mcpr_result read_ends(const Bytes& payload, FileSections& sections) {
  Cursor cursor(payload.data, payload.size, payload.offset);
  std::uint8_t* const reach = sections.end_reaches.frames;
  std::int8_t* const step_exponent = sections.end_step_exponent;
  for (int end : {kFirstPose, kLastPose}) reach[end] = cursor.read<std::uint8_t>();
  const bool has_velocity = (reach[kLastPose] & kVelocityFollows) != 0;
  reach[kLastPose] &= ~kVelocityFollows;
  for (int end : {kFirstPose, kLastPose}) step_exponent[end] = cursor.read<std::int8_t>();
  if (has_velocity) {
    reach[kVelocity] = cursor.read<std::uint8_t>();
    step_exponent[kVelocity] = cursor.read<std::int8_t>();
  }
  if (cursor.failed()) return failure(MCPR_INVALID, payload.offset, "ENDS is too short");
  for (int end = 0; end < kVelocity + (has_velocity ? 1 : 0); ++end) {
    if (reach[end] < 1 || reach[end] > sections.frames || reach[end] > kFarthestReach)
      return failure(MCPR_INVALID, payload.offset, "ENDS has an impossible reach");
    if (step_exponent[end] < kLeastEndStepExponent || step_exponent[end] > kMostEndStepExponent)
      return failure(MCPR_INVALID, payload.offset + 2, "ENDS has impossible steps");
  }
  sections.ends_bytes = payload.size;
  const std::size_t size = cursor.left();
  const std::size_t offset = cursor.offset();
  sections.coded_ends = {cursor.take(size), size, offset};
  return kOk;
}

mcpr_result read_sections(const void* file, std::size_t size, const mcpr_limits& limits,
                          FileSections& sections) {
  return SectionsReader(limits, sections)
      .read(Cursor(static_cast<const std::uint8_t*>(file), size));
}

mcpr_result read_sections(const mcpk_bank& bank, const BankEntry& entry, const mcpr_limits& limits,
                          FileSections& sections) {
  return SectionsReader(limits, sections).read(PackedSections(bank, entry));
}

}  // namespace mocapress::runtime
