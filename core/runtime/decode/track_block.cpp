// SPDX-License-Identifier: MIT
#include "core/runtime/decode/track_block.h"

#include <cmath>

#include "core/runtime/format/format_limits.h"

namespace mocapress::runtime {
namespace {

bool has_array(const mcpr_tracks& tracks, std::uint32_t offset, std::uint64_t size) {
  return offset >= sizeof(mcpr_tracks) && offset % 8 == 0 && offset + size <= tracks.bytes;
}

/// True if the runs of a held track cover all frames, one after the other.
bool has_runs(const mcpr_tracks& tracks, const ResidentTrack& track) {
  std::uint32_t frame = 0;
  const auto* const runs = tracks.at<TrackRun>(tracks.runs) + track.first;
  for (std::uint32_t r = 0; r < track.run_count; ++r) {
    if (runs[r].end <= frame || !std::isfinite(runs[r].value)) return false;
    frame = runs[r].end;
  }
  return frame == tracks.frames;
}

}  // namespace

bool are_sound(const mcpr_tracks& tracks, std::uint64_t bytes) {
  const std::uint64_t records = sizeof(ResidentTrack) * std::uint64_t{tracks.count};
  const std::uint64_t runs = sizeof(TrackRun) * std::uint64_t{tracks.run_count};
  if (bytes < sizeof tracks || tracks.bytes > bytes || tracks.frames == 0 ||
      tracks.frames > kMostFrames || tracks.count == 0 || tracks.count > kMostTracks ||
      tracks.loop > LoopKind::Follows || tracks.name_bytes == 0 ||
      !has_array(tracks, tracks.tracks, records) || !has_array(tracks, tracks.runs, runs) ||
      !has_array(tracks, tracks.names, tracks.name_bytes) ||
      tracks.at<char>(tracks.names)[tracks.name_bytes - 1] != 0)
    return false;
  std::uint32_t curves = 0;
  std::uint64_t first_run = 0;
  for (std::uint32_t t = 0; t < tracks.count; ++t) {
    const ResidentTrack& track = tracks.track(t);
    if (track.node >= tracks.name_bytes || track.name >= tracks.name_bytes ||
        track.kind > MCPR_TRACK_SCALE_Z || track.is_curve > 1 || track.steps > 1)
      return false;
    if (track.is_curve != 0) {
      if (track.first != curves++) return false;
      continue;
    }
    if (track.first != first_run || track.run_count > tracks.run_count - first_run ||
        !has_runs(tracks, track))
      return false;
    first_run += track.run_count;
  }
  if (curves != tracks.curve_count) return false;
  if (curves == 0) return tracks.curves == 0;
  return has_array(tracks, tracks.curves, sizeof(ResidentSignals)) &&
         tracks.signals().is_sound(tracks.bytes - tracks.curves, tracks.frames, curves);
}

}  // namespace mocapress::runtime
