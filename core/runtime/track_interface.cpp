// SPDX-License-Identifier: MIT
// The part of the C interface that decodes tracks: checks the arguments, then calls the
// implementation.
#include <cmath>
#include <cstring>

#include "core/runtime/decode/clip.h"
#include "core/runtime/decode/track_decoder.h"
#include "core/runtime/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/cooked_clip.h"

using namespace mocapress::runtime;

namespace {

constexpr mcpr_result wrong_track(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

bool may_ask(const mcpr_tracks* tracks, const mcpr_track_request* request) {
  return tracks != nullptr && request != nullptr && is_possible(*tracks, *request);
}

mcpr_result check_track_call(const mcpr_tracks* tracks, const mcpr_track_request* request,
                             const float* out, const void* scratch, std::size_t size) {
  if (!may_ask(tracks, request)) return wrong_track("a list of tracks that the clip does not have");
  if (out == nullptr) return wrong_track("no output");
  const std::size_t needed = mcpr_track_scratch_bytes(tracks, request);
  return needed == 0 ? kOk : check_memory(scratch, size, needed, "too little scratch memory");
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

mcpr_result mcpr_track_describe(const mcpr_tracks* tracks, uint32_t track, mcpr_track* out) {
  if (out == nullptr || track >= mcpr_track_count(tracks)) return wrong_track("no such track");
  const ResidentTrack& resident = tracks->track(track);
  const char* const names = tracks->at<char>(tracks->names);
  *out = {.node = names + resident.node,
          .name = names + resident.name,
          .kind = static_cast<mcpr_track_kind>(resident.kind),
          .steps = resident.steps};
  return kOk;
}

int32_t mcpr_find_track(const mcpr_tracks* tracks, mcpr_track_kind kind, const char* node,
                        const char* name) {
  mcpr_track track;
  for (std::uint32_t t = 0; t < mcpr_track_count(tracks); ++t) {
    mcpr_track_describe(tracks, t, &track);
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

mcpr_result mcpr_track_frames(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              uint32_t first, uint32_t count, float* out, void* scratch,
                              size_t scratch_size) {
  const mcpr_result result = check_track_call(tracks, request, out, scratch, scratch_size);
  if (failed(result)) return result;
  const std::uint32_t frames = tracks->frames;
  if (first > frames || count > frames - first) return wrong_track("frames outside the clip");
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, *tracks, *request).decode(first, count, out);
  return kOk;
}

mcpr_result mcpr_track_moment(const mcpr_tracks* tracks, const mcpr_track_request* request,
                              double frame, float* out, void* scratch, size_t scratch_size) {
  const mcpr_result result = check_track_call(tracks, request, out, scratch, scratch_size);
  if (failed(result)) return result;
  const std::uint32_t frames = tracks->frames;
  const bool goes_round = tracks->loop == LoopKind::Follows;
  if (!(frame >= 0 && (goes_round ? frame < frames : frame <= frames - 1.0)))
    return wrong_track("an instant outside the clip");
  const auto before = static_cast<std::uint32_t>(frame);
  const std::uint32_t next = before + 1 < frames ? before + 1 : 0;
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, *tracks, *request)
      .sample_between(before, next, static_cast<float>(frame - before), out);
  return kOk;
}
