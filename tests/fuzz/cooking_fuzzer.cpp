// SPDX-License-Identifier: MIT
// Cooks any bytes that open as a .mcpr. The cooked clip must pass its check and be played in every
// way, with every wrap, root motion, tracks and blends.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/fuzz/file_sections.h"
#include "tests/fuzz/played_tracks.h"
#include "tests/support/opened_clip.h"

namespace {

using mocapress::AlignedBytes;

mcpr_limits cooking_limits() {
  mcpr_limits limits = mcpr::default_limits();
  limits.values = 1U << 16;
  limits.scratch_bytes = std::size_t{16} << 20;
  limits.resident_bytes = std::size_t{8} << 20;
  limits.solver_iterations = 3;
  return limits;
}

constexpr std::uint16_t kRoot = 0;
constexpr mcpr_convention kEngine = {{1, -3, 2}, 1, 0.01F};

/// Every wrap and layout, with joints that step and without, and joints listed as an engine wants
/// them.
std::vector<mcpr_sample_request> requests() {
  std::vector<mcpr_sample_request> all;
  for (const mcpr_wrap wrap : mocapress::test::kWraps) {
    const auto layout = static_cast<mcpr_layout>(int{wrap} % int{MCPR_WRITER});
    all.push_back({.layout = layout, .wrap = wrap});
    all.push_back({.layout = layout, .wrap = wrap, .stepped = &kRoot, .stepped_count = 1});
  }
  all.push_back({.unit = MCPR_SECONDS,
                 .wrap = MCPR_LOOP_BLEND,
                 .joints = &kRoot,
                 .joint_count = 1,
                 .bands_left_out = 1,
                 .convention = &kEngine,
                 .stepped = &kRoot,
                 .stepped_count = 1});
  return all;
}

/// Samples instants before, in and after the clip, and jumps between them.
void play_cooked(const mcpr_cooked* clip) {
  const mcpr_cooked_info info = mcpr::describe(clip);
  const AlignedBytes memory(mcpr_cursor_bytes(clip));
  mcpr_cursor* cursor = nullptr;
  if (mcpr_make_cursor(clip, memory.data(), memory.size(), &cursor, nullptr) != MCPR_OK)
    std::abort();
  const double end = info.frames;
  for (mcpr_sample_request request : requests()) {
    std::vector<float> pose(mcpr_sample_values(clip, &request));
    if (pose.empty()) continue;
    // Memory of just the bytes that are asked for; a request that needs none may be given some.
    const AlignedBytes scratch(mcpr_sample_scratch_bytes(clip, &request));
    request.scratch = scratch.data();
    request.scratch_size = scratch.size();
    for (const double time : {0.0, 0.25, 1.75, end - 1, end + 0.5, -3.5, 0.5 * end, 1e9}) {
      const mcpr_status sampled = mcpr_sample(clip, &request, time, pose.data(), nullptr);
      const mcpr_status next = mcpr_sample_next(cursor, &request, time, pose.data(), nullptr);
      if (sampled != MCPR_OK || next != MCPR_OK) std::abort();
    }
    const AlignedBytes of_motion(std::size_t{64} << 10);  // it needs that of a list of joints
    request.scratch = of_motion.data();
    request.scratch_size = of_motion.size();
    mcpr_transform moved;
    for (const auto& [from, to] : {std::pair(0.0, end - 1), {end, -2.5 * end}, {0.5, 1e6}}) {
      if (mcpr_sample_motion(clip, &request, 0, from, to, &moved, nullptr) != MCPR_OK) std::abort();
      mcpr_sample_ground_motion(clip, &request, 0, from, to, &moved, nullptr);
    }
  }
  for (const double refused : {std::nan(""), HUGE_VAL}) {
    const mcpr_sample_request request{};
    std::vector<float> pose(mcpr_sample_values(clip, &request));
    if (!pose.empty() && mcpr_sample(clip, &request, refused, pose.data(), nullptr) == MCPR_OK)
      std::abort();
  }
}

/// Blends two poses of the clip in every way. Every rotation that comes out is a unit quaternion.
void blend(const mcpr_cooked* clip) {
  const std::uint32_t joints = mcpr::describe(clip).joints;
  const mcpr_sample_request whole{};
  const AlignedBytes scratch(mcpr_sample_scratch_bytes(clip, &whole));
  const mcpr_sample_request request{.scratch = scratch.data(), .scratch_size = scratch.size()};
  std::vector<mcpr_transform> first(joints), second(joints), out(joints);
  mcpr_sample(clip, &request, 0, first.data()->rotation, nullptr);
  mcpr_sample(clip, &request, 1e9, second.data()->rotation, nullptr);
  const mcpr_pose_form form{.joints = joints};
  const auto check = [&](mcpr_status status) {
    if (status != MCPR_OK) std::abort();
    for (const mcpr_transform& joint : out) {
      float square = 0;
      for (const float number : joint.rotation) square += number * number;
      if (!(std::abs(square - 1) < 1e-3F)) std::abort();
    }
  };
  const mcpr_weighted_pose both[] = {{first.data(), 1, nullptr}, {second.data(), 3, nullptr}};
  check(mcpr_blend(&form, both, 2, out.data(), nullptr));
  const mcpr_weighted_pose layer{second.data(), 0.5F, nullptr};
  check(mcpr_blend_layer(&form, &layer, out.data(), nullptr));
  check(mcpr_pose_difference(&form, second.data(), first.data(), out.data(), nullptr));
  const std::vector<mcpr_transform> difference = out;
  out = first;
  const mcpr_weighted_pose added{difference.data(), 0.5F, nullptr};
  check(mcpr_blend_additive(&form, &added, out.data(), nullptr));
  mcpr_transform ground;
  check(mcpr_split_root(nullptr, out.data(), &ground, nullptr));
  std::vector<mcpr_mirror_joint> mirror(joints);
  std::vector<std::uint16_t> partners(joints);
  std::vector<std::int16_t> parents(joints);
  for (std::uint32_t j = 0; j < joints; ++j) {
    partners[j] = static_cast<std::uint16_t>(j);
    parents[j] = static_cast<std::int16_t>(static_cast<int>(j) - 1);
  }
  if (mcpr_make_mirror(&form, first.data(), parents.data(), partners.data(), 0, mirror.data(),
                       nullptr) == MCPR_OK)
    check(mcpr_mirror_pose(&form, mirror.data(), 0, second.data(), out.data(), nullptr));
}

void cook(const mcpr_clip* clip, const mcpr_cook_options& options) {
  const AlignedBytes scratch(mcpr_cook_scratch_bytes(clip, &options));
  std::size_t size = 0;
  if (mcpr_cook_size(clip, &options, scratch.data(), scratch.size(), &size, nullptr) != MCPR_OK)
    return;
  if (size > std::size_t{32} << 20) return;
  const AlignedBytes memory(size);
  const mcpr_cooked* cooked = nullptr;
  if (mcpr_cook(clip, &options, scratch.data(), scratch.size(), memory.data(), size, &cooked,
                nullptr) != MCPR_OK)
    std::abort();
  if (mcpr_open_cooked(memory.data(), size, 1, &cooked, nullptr) != MCPR_OK) std::abort();
  if (mcpr_cooked_skeleton_hash(cooked) != (options.skeleton != 0 ? mcpr_skeleton_hash(clip) : 0))
    std::abort();
  play_cooked(cooked);
  mocapress::test::play_tracks(mcpr_cooked_tracks(cooked), mcpr::describe(cooked).frames);
  blend(cooked);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::byte> file(size);
  if (size > 0) std::memcpy(file.data(), data, size);
  mocapress::test::mend_checksums(file);
  const mcpr_limits limits = cooking_limits();
  const mocapress::test::OpenedClip clip(file, &limits);
  if (clip.clip == nullptr) return 0;
  for (const int apply_ik : {0, 1}) cook(clip.clip, {.apply_ik = apply_ik});
  cook(clip.clip, {.apply_ik = 1, .ik_error = 0.5F});
  cook(clip.clip, {.skeleton = 1});
  cook(clip.clip, {.detail_bands = 2});
  return 0;
}
