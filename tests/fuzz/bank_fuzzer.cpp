// SPDX-License-Identifier: MIT
// Opens any bytes as banks and cooked clips, with corrected checksums, and plays those that open.
#include <algorithm>
#include <vector>

#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"
#include "tests/fuzz/mended_bank.h"
#include "tests/fuzz/played_tracks.h"

namespace {

using mocapress::AlignedBytes;

constexpr const char* kNames[] = {"hips", "spine"};
constexpr mcpr_skeleton kSkeleton = {2, kNames, nullptr};

/// Samples enough neighbouring instants that whole frames are computed for them.
void sample_crowd(const mcpr_cooked* clip) {
  const mcpr_cooked_info info = mcpr::describe(clip);
  std::vector<float> pose(std::size_t{8} * info.joints);
  std::vector<mcpr_character> crowd;
  for (std::uint32_t bands = 0; bands <= MCPR_MOST_BANDS_LEFT_OUT; bands += 2)
    for (int i = 0; i < 24; ++i)
      crowd.push_back({.clip = clip,
                       .selection = nullptr,
                       .time = i < 12 ? 0.3 * i : 0.5 * info.frames + i,
                       .out = pose.data(),
                       .wrap = MCPR_CLAMP,
                       .bands_left_out = bands});
  const auto count = static_cast<std::uint32_t>(crowd.size());
  const mcpr_crowd_request request{};
  const AlignedBytes sorting(mcpr_sort_crowd_scratch_bytes(count));
  mcpr_sort_crowd(&request, crowd.data(), count, sorting.data(), sorting.size(), nullptr);
  const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
  mcpr_sample_crowd(&request, crowd.data(), count, scratch.data(), scratch.size(), nullptr);
}

void sample(const mcpr_cooked* clip) {
  const mcpr_cooked_info info = mcpr::describe(clip);
  const std::uint16_t root = 0;
  for (const mcpr_wrap wrap : mocapress::test::kWraps) {
    mcpr_sample_request request{.wrap = wrap, .stepped = &root, .stepped_count = 1};
    const AlignedBytes scratch(mcpr_sample_scratch_bytes(clip, &request));
    request.scratch = scratch.data();
    request.scratch_size = scratch.size();
    std::vector<float> pose(mcpr_sample_values(clip, &request));
    for (const double at : {0.0, 0.5, 0.5 * info.frames, info.frames - 1.0})
      if (!pose.empty()) mcpr_sample(clip, &request, at, pose.data(), nullptr);
  }
  mocapress::test::play_tracks(mcpr_cooked_tracks(clip), info.frames);
  const AlignedBytes memory(mcpr_selection_bytes(clip, 1));
  const mcpr_selection* selection = nullptr;
  if (mcpr_make_selection(clip, &root, 1, memory.data(), memory.size(), &selection, nullptr) !=
      MCPR_OK)
    return;
  sample_crowd(clip);
  float transform[8];
  for (std::uint32_t bands = 0; bands <= MCPR_MOST_BANDS_LEFT_OUT; ++bands) {
    const mcpr_sample_request request{.selection = selection, .bands_left_out = bands};
    mcpr_sample(clip, &request, 0.5 * info.frames, transform, nullptr);
  }
}

void read_packed(const mcpk_bank* bank, std::uint32_t clip, std::uint32_t tiers) {
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = tiers;
  limits.values = 1U << 16;
  limits.scratch_bytes = std::size_t{16} << 20;
  limits.resident_bytes = std::size_t{8} << 20;
  const auto made = mcpr::load(bank, clip, &limits);
  if (!made) return;
  const mcpr_clip* const built = made->get();
  const mcpr_request request{.output = MCPR_LOCAL};
  const AlignedBytes working(mcpr_scratch_bytes(built, &request));
  std::vector<float> pose(mcpr_frame_values(built, &request));
  mcpr_decode_moment(built, &request, 0.5 * mcpr::describe(built).frames, pose.data(),
                     working.data(), working.size(), nullptr);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const mocapress::test::MendedBank bytes(data, size);
  const mcpr_cooked* alone = nullptr;
  if (mcpr_open_cooked(bytes.data(), size, 1, &alone, nullptr) == MCPR_OK) {
    sample(alone);
    mcpr_cooked_skeleton_hash(alone);
    std::int16_t map[2];
    mcpr_map_gaps gaps;
    mcpr_map_cooked_joints(alone, &kSkeleton, map, &gaps, nullptr);
  }
  const mcpk_bank* bank = nullptr;
  // Checks the head only: index and packed clips may be damaged.
  if (mcpk_open(bytes.data(), size, 0, &bank, nullptr) == MCPR_OK) {
    char name[MCPK_NAME_BYTES];
    for (std::uint32_t clip = 0; clip < std::min(bank->clips, 20U); ++clip) {
      if (mcpk_name(bank, clip, name) > 0) mcpk_find(bank, name);
      mcpk_tag(bank, clip, 0);
      std::uint64_t place[2];
      mcpk_place(bank, clip, &place[0], &place[1], nullptr);
      mcpk_find_joint(bank, clip, "hips");
      mcpk_skeleton(bank, clip);
      mcpk_skeleton_hash(bank, clip);
      mcpk_tier_place(bank, clip, 1, &place[0], &place[1], nullptr);
      std::int16_t map[2];
      mcpr_map_gaps gaps;
      mcpk_map_joints(bank, clip, &kSkeleton, map, &gaps, nullptr);
      for (const std::uint32_t tiers : {0U, 1U})
        if (!bank->is_cooked()) read_packed(bank, clip, tiers);
    }
    mcpk_key(bank, 0);
    mcpk_value(bank, 0);
  }
  if (mcpk_open(bytes.data(), size, 1, &bank, nullptr) != MCPR_OK || !bank->is_cooked()) return 0;
  for (std::uint32_t clip = 0; clip < std::min(bank->clips, 20U); ++clip) {
    const mcpr_cooked* cooked = nullptr;
    if (mcpk_cooked(bank, clip, &cooked, nullptr) == MCPR_OK) sample(cooked);
  }
  return 0;
}
