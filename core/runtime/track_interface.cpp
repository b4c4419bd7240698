// SPDX-License-Identifier: MIT
// The part of the C interface that decodes tracks: checks the arguments, then calls the
// implementation.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/track_decoder.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/place_in_clip.h"
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/cooked_clip.h"

using namespace mocapress::runtime;

namespace {

constexpr mcpr_result wrong_track(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

constexpr mcpr_result impossible_request() {
  return wrong_track("a list of tracks that the clip does not have, or a sample rate below zero");
}

bool may_ask(const mcpr_tracks* tracks, const mcpr_track_request* request) {
  return tracks != nullptr && request != nullptr && is_possible(*tracks, *request);
}

mcpr_result check_track_call(const mcpr_tracks* tracks, const mcpr_track_request* request,
                             const float* out, const void* scratch, std::size_t size) {
  if (!may_ask(tracks, request)) return impossible_request();
  if (out == nullptr) return wrong_track("no output");
  const std::size_t needed = mcpr_track_scratch_bytes(tracks, request);
  return needed == 0 ? kOk : check_memory(scratch, size, needed, "too little scratch memory");
}

/// Converts an instant of a request to frames. An instant within kAtFrame of a frame is rounded to
/// that frame, as for poses.
double frame_at(const mcpr_track_request& request, double time) {
  if (!(request.sample_rate > 0)) return time;
  const double frame = time * request.sample_rate;
  const double whole = std::round(frame);
  return std::abs(frame - whole) < static_cast<double>(kAtFrame) ? whole : frame;
}

Wrapping wrapping_of(const mcpr_tracks& tracks, const mcpr_track_request& request) {
  return {static_cast<int>(tracks.frames), tracks.loop, request.wrap};
}

/// The frame whose value a held (piecewise constant) track has at an instant.
std::uint32_t frame_held_at(const Wrapping& wrapping, double frame) {
  return static_cast<std::uint32_t>(wrapping.place(frame).frame);
}

}  // namespace

const mcpr_tracks* mcpr_clip_tracks(const mcpr_clip* clip) {
  const bool is_one = clip != nullptr && clip->block.mark == ClipBlock::kMark;
  return is_one ? clip->block.scalar_tracks() : nullptr;
}

const mcpr_tracks* mcpr_cooked_tracks(const mcpr_cooked* cooked) {
  const bool has_some = is_cooked(cooked) && cooked->tracks != 0;
  return has_some ? cooked->at<mcpr_tracks>(cooked->tracks) : nullptr;
}

uint32_t mcpr_track_count(const mcpr_tracks* tracks) {
  return tracks != nullptr ? tracks->count : 0;
}

mcpr_status mcpr_track_describe(const mcpr_tracks* tracks, uint32_t track, mcpr_track* out,
                                mcpr_result* report) {
  if (out == nullptr || track >= mcpr_track_count(tracks))
    return tell(report, wrong_track("no such track"));
  const ResidentTrack& resident = tracks->track(track);
  const char* const names = tracks->at<char>(tracks->names);
  *out = {.node = names + resident.node,
          .name = names + resident.name,
          .kind = static_cast<mcpr_track_kind>(resident.kind),
          .steps = resident.steps};
  return tell(report, kOk);
}

int32_t mcpr_find_track(const mcpr_tracks* tracks, mcpr_track_kind kind, const char* node,
                        const char* name) {
  mcpr_track track;
  for (std::uint32_t t = 0; t < mcpr_track_count(tracks); ++t) {
    mcpr_track_describe(tracks, t, &track, nullptr);
    if (track.kind == kind && (node == nullptr || std::strcmp(track.node, node) == 0) &&
        (name == nullptr || std::strcmp(track.name, name) == 0))
      return static_cast<std::int32_t>(t);
  }
  return -1;
}

size_t mcpr_track_values(const mcpr_tracks* tracks, const mcpr_track_request* request) {
  if (!may_ask(tracks, request)) return 0;
  return request->tracks != nullptr ? request->track_count : tracks->count;
}

size_t mcpr_track_scratch_bytes(const mcpr_tracks* tracks, const mcpr_track_request* request) {
  if (mcpr_track_values(tracks, request) == 0) return 0;
  Memory memory;
  const TrackDecoder measured(memory, *tracks, *request);
  return static_cast<std::size_t>(memory.used());
}

mcpr_status mcpr_track_frames(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              uint32_t first, uint32_t count, float* out, void* scratch,
                              size_t scratch_size, mcpr_result* report) {
  const mcpr_result result = check_track_call(tracks, request, out, scratch, scratch_size);
  if (failed(result)) return tell(report, result);
  const std::uint32_t frames = tracks->frames;
  if (first > frames || count > frames - first)
    return tell(report, wrong_track("frames outside the clip"));
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, *tracks, *request).decode(first, count, out);
  return tell(report, kOk);
}

mcpr_status mcpr_track_moment(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              double time, float* out, void* scratch, size_t scratch_size,
                              mcpr_result* report) {
  const mcpr_result result = check_track_call(tracks, request, out, scratch, scratch_size);
  if (failed(result)) return tell(report, result);
  const double frame = frame_at(*request, time);
  const Wrapping wrapping = wrapping_of(*tracks, *request);
  if (!wrapping.is_possible())
    return tell(report, wrong_track("no such wrap, or the clip is not a loop"));
  if (!std::isfinite(frame)) return tell(report, wrong_track("no finite instant"));
  const PlaceInClip place = wrapping.place(frame);
  const auto before = static_cast<std::uint32_t>(place.frame);
  const std::uint32_t next = before + 1 < tracks->frames ? before + 1 : 0;
  const float share = place.across > 0 ? place.across : static_cast<float>(place.frame - before);
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, *tracks, *request).sample_between(before, next, share, out);
  return tell(report, kOk);
}

mcpr_status mcpr_track_changes(const mcpr_tracks* tracks, const mcpr_track_request* request,
                               double from, double to, mcpr_change* changes, uint32_t capacity,
                               uint32_t* count, mcpr_result* report) {
  if (!may_ask(tracks, request)) return tell(report, impossible_request());
  if (count == nullptr || (changes == nullptr && capacity > 0))
    return tell(report, wrong_track("no place was given for the changes, or for their number"));
  const Wrapping wrapping = wrapping_of(*tracks, *request);
  if (!wrapping.is_possible())
    return tell(report, wrong_track("no such wrap, or the clip is not a loop"));
  const double first = std::floor(frame_at(*request, std::min(from, to)));
  const double last = std::floor(frame_at(*request, std::max(from, to)));
  // If both instants are beyond the range of doubles, last - first is not a number, so the
  // comparison fails. Beyond 2^52 a double has no fractions, so `frame` +- 0.5 would be rounded.
  constexpr double kFurthest = 0x1p52;
  if (!std::isfinite(from) || !std::isfinite(to) || !(last - first <= double{kMostFrames}))
    return tell(report, wrong_track("no finite instants, or too many frames between them"));
  if (std::abs(first) > kFurthest || std::abs(last) > kFurthest)
    return tell(report, wrong_track("instants beyond 2^52 frames"));
  *count = 0;
  const auto frames = static_cast<std::uint32_t>(last - first);
  const std::size_t asked = mcpr_track_values(tracks, request);
  for (std::uint32_t i = 0; i < frames; ++i) {
    // The next frame on the way from `from` to `to`. Held tracks can change their value only at
    // whole frames: compare the values half a frame before and half a frame after.
    const double frame = from <= to ? first + 1 + i : last - i;
    const std::uint32_t before = frame_held_at(wrapping, frame - 0.5);
    const std::uint32_t after = frame_held_at(wrapping, frame + 0.5);
    for (std::uint32_t t = 0; t < asked; ++t) {
      const ResidentTrack& track =
          tracks->track(request->tracks != nullptr ? request->tracks[t] : t);
      if (track.steps == 0 || track.is_curve != 0) continue;
      const float value_before = tracks->held(track, before);
      const float value_after = tracks->held(track, after);
      if (value_before == value_after) continue;
      if (*count < capacity)
        changes[*count] = {.time = request->sample_rate > 0 ? frame / request->sample_rate : frame,
                           .track = t,
                           .value = from <= to ? value_after : value_before};
      ++*count;
    }
  }
  return tell(report, kOk);
}
