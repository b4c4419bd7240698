// SPDX-License-Identifier: MIT
// The C interface to tracks: checks what the caller hands in, and passes on.
#include <cmath>
#include <cstring>

#include "core/codec/format/result.h"
#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/track_decoder.h"

using namespace mocapress::runtime;

namespace {

constexpr mcpr_result wrong_track(const char* message) {
  return failure(MCPR_ARGUMENT, 0, message);
}

bool has_tracks(const mcpr_clip* clip) {
  return clip != nullptr && clip->block.mark == ClipBlock::kMark;
}

bool may_ask(const mcpr_clip* clip, const mcpr_track_request* request) {
  return has_tracks(clip) && request != nullptr && is_possible(clip->block, *request);
}

mcpr_result check_track_call(const mcpr_clip* clip, const mcpr_track_request* request,
                             const float* out, const void* scratch, std::size_t size) {
  if (!may_ask(clip, request)) return wrong_track("a list of tracks that the clip does not have");
  if (out == nullptr) return wrong_track("no output");
  const std::size_t needed = mcpr_track_scratch_bytes(clip, request);
  if (size < needed ||
      (needed > 0 &&
       (scratch == nullptr || reinterpret_cast<std::uintptr_t>(scratch) % kAlignment != 0)))
    return failure(MCPR_MEMORY, 0, "too little scratch memory, or not aligned");
  return kOk;
}

}  // namespace

mcpr_result mcpr_clip_track(const mcpr_clip* clip, uint32_t track, mcpr_track* out) {
  if (!has_tracks(clip) || out == nullptr || track >= clip->block.tracks.count)
    return wrong_track("no such track");
  const ClipBlock& block = clip->block;
  const ResidentTrack& resident = block.at<ResidentTrack>(block.tracks.tracks)[track];
  const char* const names = block.at<char>(block.tracks.names);
  *out = {.node = names + resident.node,
          .name = names + resident.name,
          .kind = static_cast<mcpr_track_kind>(resident.kind),
          .steps = resident.steps ? 1 : 0};
  return kOk;
}

int32_t mcpr_find_track(const mcpr_clip* clip, mcpr_track_kind kind, const char* node,
                        const char* name) {
  if (!has_tracks(clip)) return -1;
  mcpr_track track;
  for (std::uint32_t t = 0; t < clip->block.tracks.count; ++t) {
    mcpr_clip_track(clip, t, &track);
    if (track.kind == kind && (node == nullptr || std::strcmp(track.node, node) == 0) &&
        (name == nullptr || std::strcmp(track.name, name) == 0))
      return static_cast<std::int32_t>(t);
  }
  return -1;
}

size_t mcpr_track_values(const mcpr_clip* clip, const mcpr_track_request* request) {
  if (!may_ask(clip, request)) return 0;
  return request->tracks != nullptr ? request->track_count : clip->block.tracks.count;
}

size_t mcpr_track_scratch_bytes(const mcpr_clip* clip, const mcpr_track_request* request) {
  if (mcpr_track_values(clip, request) == 0) return 0;
  Memory memory;
  const TrackDecoder measured(memory, clip->block, *request);
  return static_cast<std::size_t>(memory.used());
}

mcpr_result mcpr_track_frames(const mcpr_clip* clip, const mcpr_track_request* request,
                              uint32_t first, uint32_t count, float* out, void* scratch,
                              size_t scratch_size) {
  const mcpr_result result = check_track_call(clip, request, out, scratch, scratch_size);
  if (failed(result)) return result;
  const auto frames = static_cast<std::uint32_t>(clip->block.segments.frames);
  if (first > frames || count > frames - first) return wrong_track("frames outside the clip");
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, clip->block, *request).decode(first, count, out);
  return kOk;
}

mcpr_result mcpr_track_moment(const mcpr_clip* clip, const mcpr_track_request* request,
                              double frame, float* out, void* scratch, size_t scratch_size) {
  const mcpr_result result = check_track_call(clip, request, out, scratch, scratch_size);
  if (failed(result)) return result;
  const auto frames = static_cast<std::uint32_t>(clip->block.segments.frames);
  const bool goes_round = clip->block.loop == LoopKind::Follows;
  if (!(frame >= 0 && (goes_round ? frame < frames : frame <= frames - 1.0)))
    return wrong_track("an instant outside the clip");
  const auto before = static_cast<std::uint32_t>(frame);
  const std::uint32_t next = before + 1 < frames ? before + 1 : 0;
  Memory memory(scratch, scratch_size);
  TrackDecoder(memory, clip->block, *request)
      .sample_between(before, next, static_cast<float>(frame - before), out);
  return kOk;
}
