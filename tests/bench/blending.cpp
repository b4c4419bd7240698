// SPDX-License-Identifier: MIT
// Times blends of a clip's poses beside sampling one pose, all in turns in one run.
// Usage: mocapress-blending FILE.mcpr
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/runtime/mocapress_runtime.hpp"

namespace {

using Pose = std::vector<mcpr_transform>;

constexpr int kRounds = 40;
constexpr int kPosesOfRound = 2000;

mcpr_allocator allocator() {
  return {[](void*, std::size_t size, std::size_t) -> void* {
            return ::operator new (size, std::align_val_t{MCPR_ALIGNMENT});
          },
          [](void*, void* memory) { ::operator delete (memory, std::align_val_t{MCPR_ALIGNMENT}); },
          nullptr};
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: %s FILE.mcpr\n", arguments[0]);
    return 2;
  }
  std::ifstream stream(arguments[1], std::ios::binary);
  const std::vector<char> file{std::istreambuf_iterator<char>(stream),
                               std::istreambuf_iterator<char>()};
  const mcpr_allocator memory = allocator();
  const mcpr_cooked* clip = nullptr;
  mcpr_result loaded;
  mcpr_load_cooked(file.data(), file.size(), nullptr, nullptr, &memory, &clip, &loaded);
  if (loaded.status != MCPR_OK) {
    std::fprintf(stderr, "%s: %s\n", arguments[1], loaded.message);
    return 3;
  }
  const mcpr_cooked_info info = mcpr::describe(clip);
  const mcpr_sample_request request{};
  const mcpr_pose_form form{.joints = info.joints};
  // Sixteen poses, so that nothing is known beforehand.
  std::vector<Pose> poses(16, Pose(info.joints));
  for (std::size_t i = 0; i < poses.size(); ++i)
    mcpr_sample(clip, &request, (info.frames - 1.0) * static_cast<double>(i) / 16,
                poses[i][0].rotation, nullptr);
  const std::vector<float> mask(info.joints, 0.7F);
  std::vector<std::int16_t> parents;
  std::vector<std::uint16_t> partners;
  for (std::uint32_t j = 0; j < info.joints; ++j) {
    parents.push_back(static_cast<std::int16_t>(static_cast<int>(j) - 1));
    partners.push_back(static_cast<std::uint16_t>(j));
  }
  std::vector<mcpr_mirror_joint> mirror(info.joints);
  mcpr_make_mirror(&form, poses[0].data(), parents.data(), partners.data(), 0, mirror.data(),
                   nullptr);
  Pose out(info.joints);
  mocapress::Random random(1);
  const auto pose = [&](int i) { return poses[static_cast<std::size_t>(i) % 16].data(); };

  struct Work {
    std::string name;
    std::function<void(int)> run;                            // makes pose number i
    double least = std::numeric_limits<double>::infinity();  // ns a joint
  };
  std::vector<Work> works = {
      {"a pose at a random instant",
       [&](int) {
         mcpr_sample(clip, &request, (info.frames - 1.0) * random.unit(), out[0].rotation, nullptr);
       }},
      {"a copy of a pose", [&](int i) { std::copy_n(pose(i), info.joints, out.data()); }},
      {"blend of two",
       [&](int i) {
         const mcpr_weighted_pose all[] = {{.pose = pose(i), .weight = 0.3F},
                                           {.pose = pose(i + 1), .weight = 0.7F}};
         mcpr_blend(&form, all, 2, out.data(), nullptr);
       }},
      {"blend of four",
       [&](int i) {
         const mcpr_weighted_pose all[] = {{.pose = pose(i), .weight = 0.3F},
                                           {.pose = pose(i + 1), .weight = 0.2F},
                                           {.pose = pose(i + 2), .weight = 0.4F},
                                           {.pose = pose(i + 3), .weight = 0.1F}};
         mcpr_blend(&form, all, 4, out.data(), nullptr);
       }},
      {"a masked layer",
       [&](int i) {
         const mcpr_weighted_pose layer{
             .pose = pose(i), .weight = 0.9F, .joint_weights = mask.data()};
         mcpr_blend_layer(&form, &layer, out.data(), nullptr);
       }},
      {"a difference",
       [&](int i) { mcpr_pose_difference(&form, pose(i), pose(i + 1), out.data(), nullptr); }},
      {"a difference added",
       [&](int i) {
         const mcpr_weighted_pose added{.pose = pose(i), .weight = 0.5F};
         mcpr_blend_additive(&form, &added, out.data(), nullptr);
       }},
      {"a mirror image",
       [&](int i) { mcpr_mirror_pose(&form, mirror.data(), 0, pose(i), out.data(), nullptr); }},
      {"motion of the root on the ground (whole, not a joint)", [&](int) {
         mcpr_sample_ground_motion(clip, &request, 0, (info.frames - 1.0) * random.unit(),
                                   (info.frames - 1.0) * random.unit(), out.data(), nullptr);
       }}};
  for (int round = 0; round < kRounds; ++round)
    for (Work& work : works) {
      std::copy_n(pose(0), info.joints, out.data());
      const auto begin = std::chrono::steady_clock::now();
      for (int i = 0; i < kPosesOfRound; ++i) work.run(i);
      const std::chrono::duration<double, std::nano> took =
          std::chrono::steady_clock::now() - begin;
      work.least = std::min(work.least, took.count() / kPosesOfRound / info.joints);
    }
  std::printf("%u joints, least of %d rounds\n", info.joints, kRounds);
  for (const Work& work : works)
    std::printf("%-55s %6.2f ns a joint, %.3f of a pose\n", work.name.c_str(), work.least,
                work.least / works[0].least);
  memory.release(memory.context, const_cast<mcpr_cooked*>(clip));
  return 0;
}
