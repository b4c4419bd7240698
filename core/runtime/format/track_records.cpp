// SPDX-License-Identifier: MIT
#include "core/runtime/format/track_records.h"

namespace mocapress::runtime {

mcpr_result read_track_record(Cursor& cursor, TrackRecord& record) {
  constexpr std::uint8_t kKinds = 5;
  const std::size_t begin = cursor.offset();
  record.node_length = cursor.read<std::uint8_t>();
  record.node = cursor.take(record.node_length);
  record.name_length = cursor.read<std::uint8_t>();
  record.name = cursor.take(record.name_length);
  record.kind = cursor.read<std::uint8_t>();
  record.flags = cursor.read<std::uint8_t>();
  if (cursor.failed()) return failure(MCPR_INVALID, begin, "the tracks end early");
  if (record.kind >= kKinds) return failure(MCPR_INVALID, begin, "unknown kind of track");
  if ((record.flags & ~(TrackRecord::kIsCurve | TrackRecord::kSteps)) != 0)
    return failure(MCPR_INVALID, begin, "a track has unknown flags");
  return kOk;
}

mcpr_result decode_tracks(const TracksHead& head, std::uint32_t frames, TrackByteCoder& coder,
                          std::uint8_t* records, TrackRun* runs) {
  RangeDecoder bits(head.bits.data, head.bits.size);
  const auto refuse = [&](const char* why) {
    return failure(MCPR_INVALID, head.bits.offset + bits.position(), why);
  };
  coder.run(bits, records, head.record_bytes);
  if (bits.failed()) return refuse("the coded tracks end early");
  Cursor cursor(records, head.record_bytes, head.bits.offset);
  RunCoder run_coder;
  std::uint32_t curves = 0;
  std::uint32_t run_count = 0;
  for (std::uint32_t t = 0; t < head.tracks; ++t) {
    TrackRecord record;
    const mcpr_result result = read_track_record(cursor, record);
    if (failed(result)) return result;
    curves += record.is_curve();
    for (std::uint32_t first = 0; !record.is_curve() && first < frames; ++run_count) {
      if (run_count == head.runs) return refuse("more runs of tracks than was promised");
      TrackRun& run = runs[run_count];
      run = {first, 0};
      run_coder.code(bits, first, frames, run);
      if (bits.failed()) return refuse("the coded tracks are damaged");
      first = run.end;
    }
  }
  if (!cursor.at_end() || curves != head.curves || run_count != head.runs || !bits.is_at_end())
    return refuse("other tracks than was promised");
  return kOk;
}

}  // namespace mocapress::runtime
