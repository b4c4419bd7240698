// SPDX-License-Identifier: MIT
// Opens any bytes with the runtime decoder and plays files that open in every way.
#include <algorithm>

#include "tests/fuzz/file_sections.h"
#include "tests/fuzz/played_tracks.h"
#include "tests/support/opened_clip.h"

namespace {

mcpr_limits fuzzed_limits() {
  mcpr_limits limits = mcpr::default_limits();
  limits.values = 1U << 18;
  limits.scratch_bytes = std::size_t{16} << 20;
  limits.resident_bytes = std::size_t{8} << 20;
  limits.solver_iterations = 3;
  return limits;
}

void play(const mocapress::test::OpenedClip& clip) {
  const mcpr_clip_info info = mcpr::describe(clip.clip);
  if (info.frames == 0) return;
  const std::uint32_t count = std::min<std::uint32_t>(info.frames, 20);
  const std::uint16_t channels[] = {0, static_cast<std::uint16_t>(info.channels - 1)};
  for (const mcpr_output output : {MCPR_CHANNELS, MCPR_LOCAL, MCPR_POSITIONS})
    for (const int corrected : {0, 1}) {
      const mcpr_request request{.output = output, .apply_ik = corrected};
      clip.frames(request, info.frames - count, count);
      clip.moment(request, 0.5 * (info.frames - 1));
      for (const mcpr_wrap wrap : mocapress::test::kWraps)
        clip.moment({.output = output, .apply_ik = corrected, .wrap = wrap}, info.frames - 0.5);
    }
  mocapress::test::play_tracks(mcpr_clip_tracks(clip.clip), info.frames);
  clip.tracks(info.frames - count, count);
  const mcpr_track_request first_track{channels, info.tracks > 0 ? 1U : 0U};
  float value = 0;
  const mocapress::AlignedBytes scratch(
      mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &first_track));
  mcpr_track_moment(mcpr_clip_tracks(clip.clip), &first_track, 0.5 * (info.frames - 1), &value,
                    scratch.data(), scratch.size(), nullptr);
  if (info.channels > 1)
    clip.frames({.apply_ik = 1, .bands_left_out = 1, .channels = channels, .channel_count = 2}, 0,
                count);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::byte> file(size);
  if (size > 0) std::memcpy(file.data(), data, size);
  mocapress::test::mend_checksums(file);
  mcpr_limits limits = fuzzed_limits();
  const mocapress::test::OpenedClip clip(file, &limits);
  if (clip.clip != nullptr) play(clip);
  mcpr_tier tier;
  if (mcpr_tier_of(file.data(), file.size(), 0, &tier, nullptr) != MCPR_OK) return 0;
  limits.tiers = 1;
  const mocapress::test::OpenedClip coarse(file, &limits);
  if (coarse.clip != nullptr) play(coarse);
  return 0;
}
