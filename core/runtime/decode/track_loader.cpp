// SPDX-License-Identifier: MIT
#include "core/runtime/decode/track_loader.h"

#include <algorithm>
#include <cstring>

#include "core/runtime/format/coded_motion.h"

namespace mocapress::runtime {
namespace {

std::uint64_t contexts_of(const TracksHead& head) {
  return head.curves == 0
             ? 0U
             : static_cast<std::uint64_t>(ContextLayout(static_cast<int>(head.curves)).end);
}

/// Copies a name with a terminating zero, and returns its offset.
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

std::uint32_t TrackLoader::lay_out(BlockLayout& block, LoopKind loop) const {
  if (head_.tracks == 0) return 0;
  const std::uint32_t at = block.reserve(lay_out(nullptr, loop));
  if (auto* const memory = block.at<std::byte>(at)) lay_out(memory, loop);
  return at;
}

std::uint64_t TrackLoader::lay_out(std::byte* memory, LoopKind loop) const {
  BlockLayout block(memory);
  block.reserve(sizeof(mcpr_tracks));
  mcpr_tracks made{.bytes = 0,
                   .frames = frames_,
                   .count = head_.tracks,
                   .curve_count = head_.curves,
                   .run_count = head_.runs,
                   // A record stores each name's length in one byte, of which the terminating zero
                   // takes the place. So the names need no more bytes than the records.
                   .name_bytes = head_.record_bytes,
                   .tracks = block.reserve(sizeof(ResidentTrack) * std::uint64_t{head_.tracks}),
                   .names = block.reserve(head_.record_bytes),
                   .runs = block.reserve(sizeof(TrackRun) * std::uint64_t{head_.runs}),
                   .curves = 0,
                   .loop = loop,
                   .padding = {}};
  if (head_.curves > 0) made.curves = block.reserve(ResidentSignals::size(source()));
  block.reserve(0);  // aligns the end of the block
  made.bytes = static_cast<std::uint32_t>(block.used());
  if (memory == nullptr) return block.used();
  std::memcpy(memory, &made, sizeof made);
  std::copy_n(runs_, head_.runs, block.at<TrackRun>(made.runs));
  if (head_.curves > 0) ResidentSignals::build(source(), block.at<std::byte>(made.curves));
  put_records(block.at<ResidentTrack>(made.tracks), block.at<char>(made.names));
  return block.used();
}

void TrackLoader::put_records(ResidentTrack* resident, char* names) const {
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
    resident[t].is_curve = record.is_curve() ? 1 : 0;
    resident[t].steps = record.steps() ? 1 : 0;
    resident[t].first = record.is_curve() ? curve++ : run;
    if (record.is_curve()) continue;
    while (runs_[run].end < frames_) ++run;
    resident[t].run_count = ++run - resident[t].first;
  }
}

}  // namespace mocapress::runtime
