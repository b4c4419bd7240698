// SPDX-License-Identifier: MIT
#include "core/codec/format/tiers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/section_writer.h"
#include "core/codec/format/varint.h"
#include "core/runtime/format/coded_error.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/packed_clip.h"

namespace mocapress {
namespace {

/// A tier before the file is written.
struct CutTier {
  int bands_left_out = 0;
  std::vector<std::size_t> end;  // end of each segment's bytes in this tier
  TierError error;
};

/// Returns the size of each segment without its n finest bands, for every n: bytes[n][segment].
std::vector<std::vector<std::size_t>> bytes_by_bands(const CompressedClip& clip) {
  const std::vector<SignalNeighbours> neighbours = signal_neighbours(clip);
  const SegmentLayout layout = clip.segment_layout();
  const int bands = runtime::Bands(layout.frames_of(0)).count;
  std::vector<std::vector<std::size_t>> bytes;
  for (int left_out = 0; left_out < bands; ++left_out) {
    std::vector<std::size_t>& of_segment = bytes.emplace_back();
    std::size_t first = 0;
    for (int k = 0; k < layout.count(); ++k) {
      const std::size_t size = clip.segments ? clip.segments->bytes[k] : clip.motion.size();
      of_segment.push_back(bytes_without_bands(std::span(clip.motion).subspan(first, size),
                                               neighbours, layout.frames_of(k), left_out));
      first += size;
    }
  }
  return bytes;
}

/// Chooses the bands between which the file is cut. Tiers get about the same number of bytes, and
/// enough bytes for their number of values that a reader does not refuse them.
std::vector<CutTier> cut(const CompressedClip& clip, int tiers, std::uint64_t values) {
  const std::vector<std::vector<std::size_t>> bytes = bytes_by_bands(clip);
  const auto sum = [&](int left_out) {
    const auto& of_segment = bytes[left_out];
    return static_cast<double>(std::accumulate(of_segment.begin(), of_segment.end(), 0UL));
  };
  std::vector<CutTier> cuts;
  int coarser = static_cast<int>(bytes.size());
  double bytes_before = 0;
  for (int t = 1; t < tiers; ++t) {
    const double wanted = sum(0) * t / tiers;
    int best = 0;
    for (int left_out = 1; left_out < coarser; ++left_out)
      if (sum(left_out) > bytes_before && sum(left_out) < sum(0) &&
          values <= runtime::most_values_of(static_cast<std::uint64_t>(sum(left_out))) &&
          (best == 0 || std::abs(sum(left_out) - wanted) < std::abs(sum(best) - wanted)))
        best = left_out;
    if (best == 0) continue;
    cuts.push_back({best, bytes[best], {}});
    coarser = best;
    bytes_before = sum(best);
  }
  cuts.push_back({0, bytes[0], {clip.provenance.eps_cm, clip.provenance.max_error_cm}});
  return cuts;
}

std::uint16_t error_code(float error_cm) {
  std::uint16_t code = 0;
  return runtime::find_error_code(runtime::rounded_error(error_cm), code) ? code : std::uint16_t{};
}

/// The bytes that a tier adds: those of all segments one after the other, and the size for each
/// segment.
struct Piece {
  std::vector<std::byte> bytes;
  std::vector<std::uint32_t> sizes;
};

std::vector<Piece> pieces_of(const CompressedClip& clip, const std::vector<CutTier>& tiers) {
  std::vector<Piece> pieces(tiers.size());
  std::size_t first = 0;  // where the segment begins
  for (std::size_t k = 0; k < tiers.front().end.size(); ++k) {
    std::size_t begin = 0;  // where the piece begins in the segment
    for (std::size_t t = 0; t < tiers.size(); ++t) {
      const auto bytes = std::span(clip.motion).subspan(first + begin, tiers[t].end[k] - begin);
      pieces[t].bytes.insert(pieces[t].bytes.end(), bytes.begin(), bytes.end());
      pieces[t].sizes.push_back(static_cast<std::uint32_t>(bytes.size()));
      begin = tiers[t].end[k];
    }
    first += begin;
  }
  return pieces;
}

/// The payload of CLIP with other errors.
std::vector<std::byte> description_with(std::span<const std::byte> payload,
                                        const TierError& error) {
  std::vector<std::byte> changed(payload.begin(), payload.end());
  const float errors[] = {error.eps_cm, error.max_error_cm};
  std::memcpy(changed.data() + runtime::kErrorsAt, errors, sizeof errors);
  return changed;
}

/// Copies the sections of a file except TIER, with SEGS and MOTN made from `pieces`. If the motion
/// lacks its finest bands, `coarse` is its error, which replaces the errors in CLIP, and ENDS is
/// left out. The file may end after its sections.
void copy_sections(std::span<const std::byte> mcpr, const std::vector<Piece>& pieces,
                   const std::optional<TierError>& coarse, std::uint16_t& count,
                   ByteWriter& sections) {
  runtime::Cursor file(reinterpret_cast<const std::uint8_t*>(mcpr.data()), mcpr.size());
  std::uint16_t left = 0;
  require(runtime::read_head(file, left));
  for (; left > 0; --left) {
    runtime::Section section;
    require(runtime::read_section(file, section));
    if (section.is("TIER") || (coarse && section.is("ENDS"))) continue;
    ++count;
    const auto payload = mcpr.subspan(section.payload.offset, section.payload.size);
    if (section.is("SEGS")) {
      constexpr std::size_t kHead = 12;  // length, overlap, segments
      ByteWriter segments;
      segments.append(payload.first(kHead));
      for (const Piece& piece : pieces) segments.append(std::as_bytes(std::span(piece.sizes)));
      write_section(sections, "SEGS", segments.bytes());
    } else if (section.is("MOTN")) {
      write_section(sections, "MOTN", pieces.front().bytes);
    } else if (coarse && section.is("CLIP")) {
      write_section(sections, "CLIP", description_with(payload, *coarse));
    } else {
      sections.append(mcpr.subspan(section.start, file.offset() - section.start));
    }
  }
}

/// Writes the file with its motion in these tiers.
std::vector<std::byte> write_file(std::span<const std::byte> mcpr, const std::vector<Piece>& pieces,
                                  const std::vector<CutTier>& tiers) {
  std::uint16_t count = 0;
  ByteWriter sections;
  copy_sections(mcpr, pieces, {}, count, sections);
  runtime::TierTable table;
  table.count = static_cast<int>(tiers.size());
  std::vector<TierBytes> bytes = {{sections.bytes().size()}};
  for (std::size_t t = 0; t < tiers.size(); ++t) {
    table.tier[t].bands_left_out = tiers[t].bands_left_out;
    table.tier[t].eps_cm = tiers[t].error.eps_cm;
    table.tier[t].max_error_cm = tiers[t].error.max_error_cm;
    if (t > 0) bytes.push_back(tier_bytes(pieces[t].bytes));
  }
  ByteWriter file;
  write_head(file, static_cast<std::uint16_t>(count + 1));
  write_section(file, kTiers, write_tiers(table, bytes));
  file.append(sections.bytes());
  for (std::size_t t = 1; t < tiers.size(); ++t) file.append(pieces[t].bytes);
  return file.release();
}

/// Writes the file with its motion in one piece.
std::vector<std::byte> write_whole(std::span<const std::byte> mcpr, Piece motion,
                                   const std::optional<TierError>& coarse) {
  std::uint16_t count = 0;
  ByteWriter sections;
  copy_sections(mcpr, {std::move(motion)}, coarse, count, sections);
  ByteWriter file;
  write_head(file, count);
  file.append(sections.bytes());
  return file.release();
}

}  // namespace

TierBytes tier_bytes(std::span<const std::byte> piece) {
  return {piece.size(),
          runtime::crc32(reinterpret_cast<const std::uint8_t*>(piece.data()), piece.size())};
}

std::vector<std::byte> write_tiers(const runtime::TierTable& tiers,
                                   const std::vector<TierBytes>& bytes) {
  std::vector<std::byte> payload = {static_cast<std::byte>(tiers.count)};
  const auto append = [&](const auto& number) {
    const auto all = std::as_bytes(std::span(&number, 1));
    payload.insert(payload.end(), all.begin(), all.end());
  };
  for (std::size_t t = 0; t < static_cast<std::size_t>(tiers.count); ++t) {
    if (!bytes.empty()) write_varint(payload, bytes[t].size);
    if (!bytes.empty() && t > 0) append(bytes[t].checksum);
    if (t + 1 == static_cast<std::size_t>(tiers.count)) break;
    const runtime::Tier& tier = tiers.tier[t];
    append(static_cast<std::uint8_t>(tier.bands_left_out));
    append(error_code(tier.eps_cm));
    append(error_code(tier.max_error_cm));
  }
  return payload;
}

std::vector<std::byte> with_tiers(std::span<const std::byte> mcpr, int tiers,
                                  const MeasureTier& measure) {
  if (tiers < 2) return {mcpr.begin(), mcpr.end()};
  const Container container = read_any_container(mcpr);
  const CompressedClip& clip = container.clip;
  if (container.of_comparison || clip.coding != Coding::Adaptive) return {mcpr.begin(), mcpr.end()};
  std::vector<CutTier> cuts = cut(clip, tiers, sections_of(mcpr).room_values());
  if (cuts.size() == 1) return without_tiers(mcpr);
  const std::vector<Piece> pieces = pieces_of(clip, cuts);
  const std::vector<std::byte> unmeasured = write_file(mcpr, pieces, cuts);
  for (std::size_t t = 0; t + 1 < cuts.size(); ++t)
    cuts[t].error = measure(unmeasured, static_cast<int>(t) + 1);
  return write_file(mcpr, pieces, cuts);
}

std::vector<std::byte> file_of_tiers(std::span<const std::byte> mcpr, int tiers) {
  const runtime::FileSections sections = sections_of(mcpr, tiers);
  if (sections.tiers_read != tiers)
    throw FormatError(0, "the file has " + std::to_string(sections.tiers_read) + " tiers, not " +
                             std::to_string(tiers));
  if (sections.bands_left_out() == 0) return without_tiers(mcpr);
  const CompressedClip clip = read_container(mcpr, tiers);
  Piece motion;
  AdaptiveSegments segments(clip);
  for (int k = 0; k < clip.segment_layout().count(); ++k) {
    const std::vector<std::byte> segment = pack_adaptive(segments.next(), clip);
    motion.bytes.insert(motion.bytes.end(), segment.begin(), segment.end());
    motion.sizes.push_back(static_cast<std::uint32_t>(segment.size()));
  }
  const runtime::Tier& tier = sections.tiers.tier[tiers - 1];
  std::vector<std::byte> file =
      write_whole(mcpr.first(std::min(sections.tiers.file_bytes(0), mcpr.size())),
                  std::move(motion), TierError{tier.eps_cm, tier.max_error_cm});
  sections_of(file);  // throws if a file of so few bytes may not have so many values
  return file;
}

std::vector<std::byte> without_tiers(std::span<const std::byte> mcpr) {
  const Container container = read_any_container(mcpr);
  const CompressedClip& clip = container.clip;
  if (sections_of(mcpr).tiers.count == 0) return {mcpr.begin(), mcpr.end()};
  Piece motion{clip.motion, {}};
  if (clip.segments) motion.sizes = clip.segments->bytes;
  return write_whole(mcpr, std::move(motion), {});
}

}  // namespace mocapress
