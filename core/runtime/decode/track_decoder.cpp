// SPDX-License-Identifier: MIT
#include "core/runtime/decode/track_decoder.h"

#include <algorithm>
#include <bitset>

#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/track_records.h"

namespace mocapress::runtime {

bool is_possible(const mcpr_tracks& tracks, const mcpr_track_request& request) {
  if (!(request.sample_rate >= 0)) return false;
  if (request.tracks == nullptr) return request.track_count == 0;
  if (request.track_count > tracks.count) return false;
  std::bitset<kMostTracks> seen;
  for (std::uint32_t i = 0; i < request.track_count; ++i) {
    const std::uint16_t t = request.tracks[i];
    if (t >= tracks.count || seen[t]) return false;
    seen[t] = true;
  }
  return true;
}

TrackDecoder::TrackDecoder(Memory& memory, const mcpr_tracks& tracks,
                           const mcpr_track_request& request)
    : tracks_(tracks),
      request_(request),
      count_(request.tracks != nullptr ? request.track_count : tracks.count) {
  next_row_ = memory.take<float>(count_);
  const auto curves = static_cast<int>(tracks.curve_count);
  if (curves == 0) return;
  columns_ = memory.take<std::int32_t>(tracks.curve_count);
  if (columns_ != nullptr) {
    std::fill_n(columns_, curves, ResidentSignals::Columns::kNone);
    for (std::size_t i = 0; i < count_; ++i)
      if (track(i).is_curve != 0) columns_[track(i).first] = static_cast<std::int32_t>(i);
  }
  curves_.emplace(memory, tracks.signals(),
                  SignalRequest{.column_of_signal = columns_,
                                .in_order = false,
                                .columns = static_cast<int>(count_),
                                .bands_left_out = 0,
                                .kernels = &best_rows()});
}

const ResidentTrack& TrackDecoder::track(std::size_t place) const {
  const std::size_t t = request_.tracks != nullptr ? request_.tracks[place] : place;
  return tracks_.track(t);
}

void TrackDecoder::decode(std::uint32_t first, std::uint32_t count, float* out) {
  for (std::uint32_t at = 0; at < count && curves_;) {
    const std::uint32_t frames = std::min<std::uint32_t>(count - at, kWindow);
    curves_->decode_window(static_cast<int>(first + at), static_cast<int>(frames),
                           out + std::size_t{at} * count_, static_cast<std::ptrdiff_t>(count_));
    at += frames;
  }
  for (std::size_t i = 0; i < count_; ++i)
    if (track(i).is_curve == 0) put_held(i, first, count, out + i);
}

/// Writes the values of a held track, the requested track number `place`. Starts in the run that
/// contains the first frame.
void TrackDecoder::put_held(std::size_t place, std::uint32_t first, std::uint32_t count,
                            float* out) const {
  const TrackRun* run = tracks_.run_at(track(place), first);
  for (std::uint32_t t = first; t < first + count; ++t, out += count_) {
    if (t >= run->end) ++run;
    *out = run->value;
  }
}

void TrackDecoder::sample_between(std::uint32_t frame, std::uint32_t next, float share,
                                  float* out) {
  decode(frame, 1, out);
  if (!(share > 0)) return;
  decode(next, 1, next_row_);
  for (std::size_t i = 0; i < count_; ++i)
    if (track(i).steps == 0) out[i] += share * (next_row_[i] - out[i]);
}

}  // namespace mocapress::runtime
