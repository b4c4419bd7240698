// SPDX-License-Identifier: MIT
#include "core/runtime/track_loader.h"

#include <algorithm>
#include <cstring>

#include "core/codec/format/coded_motion.h"

namespace mocapress::runtime {
namespace {

std::uint64_t contexts_of(const TracksHead& head) {
  return head.curves == 0
             ? 0U
             : static_cast<std::uint64_t>(ContextLayout(static_cast<int>(head.curves)).end);
}

/// Copies a name and a zero behind it, and gives its place.
std::uint32_t put_name(const std::uint8_t* name, std::uint8_t length, char* names,
                       std::uint32_t& used) {
  const std::uint32_t at = used;
  if (length > 0) std::memcpy(names + at, name, length);
  used += length + 1U;
  return at;
}

}  // namespace

TrackLoader::TrackLoader(Memory& memory, const FileSections& sections,
                         const JointByteCoder& done_with)
    : head_(sections.tracks),
      frames_(sections.frames),
      records_(memory.take<std::uint8_t>(head_.record_bytes)),
      runs_(memory.take<TrackRun>(head_.runs)),
      neighbours_(memory.take<SignalNeighbours>(head_.curves)),
      contexts_(memory.take<AdaptiveBit>(contexts_of(head_))),
      step_exponents_(memory.take<std::int32_t>(head_.curves)),
      values_(memory.take<std::int32_t>(std::uint64_t{head_.curves} * frames_)),
      steps_(memory.take<float>(head_.curves)),
      double_precision_limits_(memory.take<float>(head_.curves)),
      notes_(memory.take<std::uint8_t>(head_.curves)),
      bands_(head_.curves > 0 ? static_cast<int>(frames_) : 0),
      coder_notes_(memory, bands_, static_cast<int>(head_.curves)),
      byte_coder_(done_with.slots()) {}

mcpr_result TrackLoader::read() {
  if (head_.tracks == 0) return kOk;
  const mcpr_result result = decode_tracks(head_, frames_, byte_coder_, records_, runs_);
  return failed(result) || head_.curves == 0 ? result : read_curves();
}

mcpr_result TrackLoader::read_curves() {
  const auto curves = static_cast<int>(head_.curves);
  set_track_neighbours(curves, neighbours_);
  CoefficientModel model(curves, contexts_);
  const QuantisedView view{static_cast<int>(frames_), curves, step_exponents_, values_};
  float scale = 0;
  const mcpr_result result =
      decode_coefficients(head_.stream, neighbours_, bands_, model, view, coder_notes_, scale);
  if (failed(result)) return result;
  for (int s = 0; s < curves; ++s)
    steps_[s] = static_cast<float>(step_of(step_exponents_[s], scale));
  std::fill_n(double_precision_limits_, curves, kTrackDoublePrecision);
  return kOk;
}

QuantisedSource TrackLoader::source() const {
  return {.length = static_cast<int>(frames_),
          .signal_count = static_cast<int>(head_.curves),
          .wavelet = head_.wavelet,
          .steps = steps_,
          .double_precision_limits = double_precision_limits_,
          .values = values_,
          .notes = notes_,
          .budget_bytes = 2 * std::uint64_t{head_.stream.size}};
}

TrackBlock TrackLoader::lay_out(BlockLayout& block) const {
  TrackBlock tracks;
  if (head_.tracks == 0) return tracks;
  tracks.count = head_.tracks;
  tracks.curve_count = head_.curves;
  tracks.tracks = block.reserve(sizeof(ResidentTrack) * std::uint64_t{head_.tracks});
  // Of a record's bytes two are lengths, where names here end with zeros.
  tracks.names = block.reserve(head_.record_bytes);
  tracks.runs = block.reserve(sizeof(TrackRun) * std::uint64_t{head_.runs});
  if (head_.curves > 0) tracks.curves = block.reserve(ResidentSignals::size(source()));
  auto* const resident = block.at<ResidentTrack>(tracks.tracks);
  if (resident == nullptr) return tracks;
  std::copy_n(runs_, head_.runs, block.at<TrackRun>(tracks.runs));
  if (head_.curves > 0) ResidentSignals::build(source(), block.at<std::byte>(tracks.curves));
  char* const names = block.at<char>(tracks.names);
  Cursor cursor(records_, head_.record_bytes);
  std::uint32_t name_bytes = 0;
  std::uint32_t curve = 0;
  std::uint32_t run = 0;
  for (std::uint32_t t = 0; t < head_.tracks; ++t) {
    TrackRecord record;
    read_track_record(cursor, record);
    resident[t].node = put_name(record.node, record.node_length, names, name_bytes);
    resident[t].name = put_name(record.name, record.name_length, names, name_bytes);
    resident[t].kind = record.kind;
    resident[t].is_curve = record.is_curve();
    resident[t].steps = record.steps();
    resident[t].first = record.is_curve() ? curve++ : run;
    if (record.is_curve()) continue;
    while (runs_[run].end < frames_) ++run;
    resident[t].run_count = ++run - resident[t].first;
  }
  return tracks;
}

}  // namespace mocapress::runtime
