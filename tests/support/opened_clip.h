// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"

namespace mocapress::test {

/// A clip opened by the runtime decoder into its own memory, as an engine would do it.
struct OpenedClip {
  mcpr_info info{};
  mcpr_result result{};  // result of the step that failed, or of the last one
  std::optional<AlignedBytes> resident;
  const mcpr_clip* clip = nullptr;  // null if it was refused

  explicit OpenedClip(std::span<const std::byte> file, const mcpr_limits* limits = nullptr) {
    mcpr_inspect(file.data(), file.size(), limits, &info, &result);
    if (result.status != MCPR_OK) return;
    const AlignedBytes scratch(info.read_bytes);
    std::size_t size = 0;
    mcpr_read(file.data(), file.size(), limits, scratch.data(), scratch.size(), &size, &result);
    if (result.status != MCPR_OK) return;
    resident.emplace(size);
    mcpr_build(scratch.data(), scratch.size(), resident->data(), size, &clip, &result);
  }

  /// Requested frames, row after row; empty if they were refused.
  std::vector<float> frames(const mcpr_request& request, std::uint32_t first,
                            std::uint32_t count) const {
    const AlignedBytes scratch(mcpr_scratch_bytes(clip, &request));
    std::vector<float> out(count * mcpr_frame_values(clip, &request));
    if (mcpr_decode_frames(clip, &request, first, count, out.data(), scratch.data(), scratch.size(),
                           nullptr) != MCPR_OK)
      out.clear();
    return out;
  }

  /// All tracks, row after row; empty if they were refused.
  std::vector<float> tracks(std::uint32_t first, std::uint32_t count) const {
    return frames_of(mcpr_clip_tracks(clip), first, count);
  }

  static std::vector<float> frames_of(const mcpr_tracks* tracks, std::uint32_t first,
                                      std::uint32_t count) {
    const mcpr_track_request all{};
    const AlignedBytes scratch(mcpr_track_scratch_bytes(tracks, &all));
    std::vector<float> out(count * mcpr_track_values(tracks, &all));
    if (mcpr_track_frames(tracks, &all, first, count, out.data(), scratch.data(), scratch.size(),
                          nullptr) != MCPR_OK)
      out.clear();
    return out;
  }

  std::vector<float> moment(const mcpr_request& request, double frame) const {
    const AlignedBytes scratch(mcpr_scratch_bytes(clip, &request));
    std::vector<float> out(mcpr_frame_values(clip, &request));
    if (mcpr_decode_moment(clip, &request, frame, out.data(), scratch.data(), scratch.size(),
                           nullptr) != MCPR_OK)
      out.clear();
    return out;
  }
};

}  // namespace mocapress::test
