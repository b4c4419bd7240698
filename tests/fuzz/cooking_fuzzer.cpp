// SPDX-License-Identifier: MIT
// Cooks any bytes that open as a .mcpr. The cooked clip must pass its check and be played in every
// way, with loops and root motion.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/fuzz/file_sections.h"
#include "tests/support/opened_clip.h"

namespace {

using mocapress::AlignedBytes;

mcpr_limits fuzzed_limits() {
  mcpr_limits limits = mcpr_default_limits();
  limits.values = 1U << 16;
  limits.scratch_bytes = std::size_t{16} << 20;
  limits.resident_bytes = std::size_t{8} << 20;
  limits.solver_iterations = 3;
  return limits;
}

/// Samples instants before, in and after the clip, and jumps between them.
void play(const mcpr_cooked* clip) {
  const mcpr_cooked_info info = mcpr_cooked_describe(clip);
  const AlignedBytes memory(mcpr_cursor_bytes(clip));
  mcpr_cursor* cursor = nullptr;
  if (mcpr_make_cursor(clip, memory.data(), memory.size(), &cursor).status != MCPR_OK) std::abort();
  const double end = info.frames;
  for (const mcpr_wrap wrap : {MCPR_CLAMP, MCPR_LOOP})
    for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS, MCPR_MATRICES}) {
      const mcpr_sample_request request{.layout = layout, .wrap = wrap};
      std::vector<float> pose(mcpr_sample_values(clip, &request));
      if (pose.empty()) continue;
      for (const double time : {0.0, 0.25, 1.75, end - 1, end + 0.5, -3.5, 0.5 * end, 1e9}) {
        mcpr_sample(clip, &request, time, pose.data());
        mcpr_sample_next(cursor, &request, time, pose.data());
      }
      mcpr_transform moved;
      for (const auto& [from, to] : {std::pair(0.0, end - 1), {end, -2.5 * end}, {0.5, 1e6}})
        mcpr_sample_motion(clip, &request, 0, from, to, &moved);
    }
  for (const double refused : {std::nan(""), HUGE_VAL}) {
    const mcpr_sample_request request{};
    std::vector<float> pose(mcpr_sample_values(clip, &request));
    if (!pose.empty() && mcpr_sample(clip, &request, refused, pose.data()).status == MCPR_OK)
      std::abort();
  }
  mocapress::test::OpenedClip::frames_of(mcpr_cooked_tracks(clip), 0,
                                         std::min<std::uint32_t>(info.frames, 8));
}

void cook(const mcpr_clip* clip, const mcpr_cook_options& options) {
  const AlignedBytes scratch(mcpr_cook_scratch_bytes(clip, &options));
  std::size_t size = 0;
  if (mcpr_cook_size(clip, &options, scratch.data(), scratch.size(), &size).status != MCPR_OK)
    return;
  if (size > std::size_t{32} << 20) return;
  const AlignedBytes memory(size);
  const mcpr_cooked* cooked = nullptr;
  if (mcpr_cook(clip, &options, scratch.data(), scratch.size(), memory.data(), size, &cooked)
          .status != MCPR_OK)
    std::abort();
  if (mcpr_open_cooked(memory.data(), size, 1, &cooked).status != MCPR_OK) std::abort();
  if (mcpr_cooked_skeleton_hash(cooked) != (options.skeleton != 0 ? mcpr_skeleton_hash(clip) : 0))
    std::abort();
  play(cooked);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::byte> file(size);
  if (size > 0) std::memcpy(file.data(), data, size);
  mocapress::test::mend_checksums(file);
  const mcpr_limits limits = fuzzed_limits();
  const mocapress::test::OpenedClip clip(file, &limits);
  if (clip.clip == nullptr) return 0;
  for (const int apply_ik : {0, 1}) cook(clip.clip, {.apply_ik = apply_ik});
  cook(clip.clip, {.skeleton = 1});
  return 0;
}
