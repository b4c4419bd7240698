// SPDX-License-Identifier: MIT
#include "core/codec/format/tracks_section.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/byte_cursor.h"
#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/container.h"
#include "core/codec/format/format_error.h"
#include "core/codec/format/range_coder.h"
#include "core/codec/format/room.h"
#include "core/codec/format/section_writer.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/track_records.h"
#include "core/runtime/own_memory.h"

namespace mocapress {
namespace {

std::vector<SignalNeighbours> track_neighbours(int curves) {
  std::vector<SignalNeighbours> neighbours(curves);
  runtime::set_track_neighbours(curves, neighbours.data());
  return neighbours;
}

std::vector<runtime::TrackRun> runs_of(const std::vector<float>& values) {
  std::vector<runtime::TrackRun> runs;
  for (std::size_t t = 0; t < values.size(); ++t) {
    // Compared by bits, so that -0 is kept.
    const bool is_new = t == 0 || std::bit_cast<std::uint32_t>(values[t]) !=
                                      std::bit_cast<std::uint32_t>(values[t - 1]);
    if (is_new) runs.push_back({0, values[t]});
    runs.back().end = static_cast<std::uint32_t>(t) + 1;
  }
  return runs;
}

void write_runs(const ScalarTrack& track, runtime::RunCoder& coder, RangeEncoder& bits) {
  std::uint32_t first = 0;
  for (runtime::TrackRun run : runs_of(track.values)) {
    coder.code(bits, first, static_cast<std::uint32_t>(track.values.size()), run);
    first = run.end;
  }
}

/// The records of tracks, before compression.
std::vector<std::byte> records_of(const CodedTracks& coded) {
  ByteWriter writer;
  for (std::size_t t = 0; t < coded.tracks.size(); ++t) {
    const ScalarTrack& track = coded.tracks[t];
    writer.write_short_string(track.node);
    writer.write_short_string(track.name);
    writer.write(static_cast<std::uint8_t>(track.kind));
    writer.write(
        static_cast<std::uint8_t>((coded.is_curve[t] ? runtime::TrackRecord::kIsCurve : 0) |
                                  (track.steps ? runtime::TrackRecord::kSteps : 0)));
  }
  return writer.release();
}

void check(const CodedTracks& coded, const runtime::FileSections& sections) {
  const auto refuse = [](const std::string& why) {
    throw Error("its tracks cannot be kept: " + why);
  };
  if (coded.tracks.size() > runtime::kMostTracks)
    refuse("there are " + std::to_string(coded.tracks.size()) + ", at most " +
           std::to_string(runtime::kMostTracks) + " are possible");
  for (std::size_t t = 0; t < coded.tracks.size(); ++t) {
    const ScalarTrack& track = coded.tracks[t];
    if (std::max(track.node.size(), track.name.size()) > runtime::kMostNameBytes)
      refuse("the name of one has more than " + std::to_string(runtime::kMostNameBytes) + " bytes");
    if (coded.is_curve[t]) continue;
    if (track.values.size() != sections.frames)
      refuse(shortened(track.name) + " has another number of frames than the clip");
    if (!std::ranges::all_of(track.values, [](float v) { return std::isfinite(v); }))
      refuse(shortened(track.name) + " has a value that is not finite");
  }
}

/// The payload of trks, and its number of runs of equal values.
std::pair<std::vector<std::byte>, std::uint32_t> write_tracks(const CodedTracks& coded) {
  std::vector<std::byte> records = records_of(coded);
  RangeEncoder bits;
  const OwnMemory<runtime::JointByteCoder> memory;
  runtime::TrackByteCoder((*memory).slots())
      .run(bits, reinterpret_cast<std::uint8_t*>(records.data()),
           static_cast<std::uint32_t>(records.size()));
  runtime::RunCoder coder;
  std::size_t runs = 0;
  for (std::size_t t = 0; t < coded.tracks.size(); ++t) {
    if (coded.is_curve[t]) continue;
    runs += runs_of(coded.tracks[t].values).size();
    write_runs(coded.tracks[t], coder, bits);
  }
  std::vector<std::byte> curves;
  if (coded.curves.signal_count() > 0) curves = curve_bytes(coded.curves);
  ByteWriter writer;
  writer.write(static_cast<std::uint16_t>(coded.tracks.size()));
  writer.write(static_cast<std::uint16_t>(coded.curves.signal_count()));
  writer.write(static_cast<std::uint8_t>(coded.basis));
  writer.write(static_cast<std::uint32_t>(records.size()));
  writer.write(static_cast<std::uint32_t>(runs));
  writer.write(static_cast<std::uint32_t>(curves.size()));
  writer.append(curves);
  writer.append(bits.finish());
  return {writer.release(), static_cast<std::uint32_t>(runs)};
}

}  // namespace

std::vector<std::byte> curve_bytes(const QuantisedSignals& curves) {
  return adaptive_encode(curves, track_neighbours(curves.signal_count()));
}

std::size_t held_bits(const ScalarTrack& track) {
  RangeEncoder bits;
  runtime::RunCoder coder;
  write_runs(track, coder, bits);
  return 8 * bits.finish().size();
}

std::vector<std::byte> with_coded_tracks(std::span<const std::byte> mcpr,
                                         const CodedTracks& coded) {
  if (coded.tracks.empty()) return with_section(mcpr, "trks", std::nullopt);
  runtime::FileSections sections = sections_of(mcpr);
  check(coded, sections);
  const auto [payload, runs] = write_tracks(coded);
  sections.tracks = {.curves = static_cast<std::uint32_t>(coded.curves.signal_count()),
                     .runs = runs};
  if (sections.value_count() > runtime::kMostValues)
    throw Error("its tracks cannot be kept: motion and tracks have " +
                std::to_string(sections.value_count()) + " values, at most " +
                std::to_string(runtime::kMostValues) + " are possible");
  std::vector<std::byte> file = with_section(mcpr, "trks", payload);
  check_room(sections.room_values(), file.size());
  return file;
}

CodedTracks coded_tracks_of(std::span<const std::byte> mcpr) {
  const runtime::FileSections sections = sections_of(mcpr);
  const runtime::TracksHead& head = sections.tracks;
  CodedTracks coded;
  if (head.tracks == 0) return coded;
  std::vector<std::uint8_t> records(head.record_bytes);
  std::vector<runtime::TrackRun> runs(head.runs);
  const OwnMemory<runtime::JointByteCoder> memory;
  runtime::TrackByteCoder coder((*memory).slots());
  require(runtime::decode_tracks(head, sections.frames, coder, records.data(), runs.data()));
  coded.basis = head.wavelet;
  if (head.curves > 0)
    coded.curves =
        adaptive_decode({reinterpret_cast<const std::byte*>(head.stream.data), head.stream.size},
                        track_neighbours(static_cast<int>(head.curves)),
                        static_cast<int>(sections.frames), head.stream.offset);
  runtime::Cursor cursor(records.data(), records.size());
  std::size_t run = 0;
  for (std::uint32_t t = 0; t < head.tracks; ++t) {
    runtime::TrackRecord record;
    require(runtime::read_track_record(cursor, record));
    ScalarTrack track{.kind = static_cast<TrackKind>(record.kind),
                      .node = {reinterpret_cast<const char*>(record.node), record.node_length},
                      .name = {reinterpret_cast<const char*>(record.name), record.name_length},
                      .steps = record.steps(),
                      .values = {}};
    while (!record.is_curve() && track.values.size() < sections.frames) {
      track.values.resize(runs[run].end, runs[run].value);
      ++run;
    }
    coded.tracks.push_back(std::move(track));
    coded.is_curve.push_back(record.is_curve());
  }
  return coded;
}

std::size_t track_bytes_of(std::span<const std::byte> mcpr) {
  return sections_of(mcpr).tracks.bytes;
}

}  // namespace mocapress
