// SPDX-License-Identifier: MIT
// Threads that share clips and banks: each gets what one thread alone gets. The thread sanitizer
// watches when it is on (tests/run tsan).
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "core/base/file.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"

namespace mocapress::threads_test {
namespace {

constexpr int kThreads = 4;

std::vector<std::byte> bytes_of(const std::string& name) {
  return read_bytes(std::string(MOCAPRESS_SOURCE_DIR) + "/tests/fuzz/corpus/" + name);
}

AlignedBytes aligned(const std::string& name) {
  const std::vector<std::byte> file = bytes_of(name);
  AlignedBytes memory(file.size());
  std::copy(file.begin(), file.end(), memory.data());
  return memory;
}

/// Everything that threads may share.
class Shared {
 public:
  Shared() {
    mcpk_open(cooked_bytes_.data(), cooked_bytes_.size(), 1, &cooked_, nullptr);
    mcpk_open(packed_bytes_.data(), packed_bytes_.size(), 1, &packed_, nullptr);
    const mcpr_cooked* const clip = clip_of(0);
    selection_bytes_.emplace(mcpr_selection_bytes(clip, 2));
    const std::uint16_t joints[] = {1, 0};
    mcpr_make_selection(clip, joints, 2, selection_bytes_->data(), selection_bytes_->size(),
                        &selection_, nullptr);
  }

  /// All that one thread asks for, with scratch memory and cursors of its own.
  std::vector<float> played() const {
    std::vector<float> all;
    const auto add = [&](const std::vector<float>& values) {
      EXPECT_FALSE(values.empty());
      all.insert(all.end(), values.begin(), values.end());
    };
    add(opened_.frames({.output = MCPR_LOCAL, .apply_ik = 1}, 0, opened_.info.frames));
    for (double frame = 0; frame < 30; frame += 1.7) {
      add(opened_.moment({.output = MCPR_POSITIONS, .apply_ik = 1}, frame));
      add(posed(clip_of(0), frame, selection_));
    }
    for (std::uint32_t c = 0; c < mcpr::describe(cooked_).clips; ++c) add(crowd(clip_of(c)));
    for (std::uint32_t c = 0; c < mcpr::describe(packed_).clips; ++c)
      add(posed(mcpr::load_cooked(packed_, c)->get(), 3.3, nullptr));
    return all;
  }

 private:
  const mcpr_cooked* clip_of(std::uint32_t number) const {
    const mcpr_cooked* clip = nullptr;
    mcpk_cooked(cooked_, number, &clip, nullptr);
    return clip;
  }

  static std::vector<float> posed(const mcpr_cooked* clip, double frame,
                                  const mcpr_selection* selection) {
    const mcpr_sample_request request{.wrap = MCPR_PING_PONG, .selection = selection};
    std::vector<float> pose(mcpr_sample_values(clip, &request));
    auto player = mcpr::Player::of(clip);
    return player->sample(request, frame, pose).status == MCPR_OK ? pose : std::vector<float>();
  }

  /// So many characters that their frames are made together.
  static std::vector<float> crowd(const mcpr_cooked* clip) {
    constexpr std::size_t kCharacters = 40;
    const mcpr_crowd_request request{};
    const std::size_t values = 8 * mcpr::describe(clip).joints;
    std::vector<float> poses(kCharacters * values);
    std::vector<mcpr_character> characters;
    for (std::size_t i = 0; i < kCharacters; ++i)
      characters.push_back(
          {.clip = clip, .time = 0.21 * static_cast<double>(i), .out = poses.data() + i * values});
    const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
    EXPECT_EQ(mcpr_sample_crowd(&request, characters.data(), kCharacters, scratch.data(),
                                scratch.size(), nullptr),
              MCPR_OK);
    return poses;
  }

  const test::OpenedClip opened_{bytes_of("runtime/corrected.mcpr")};
  const AlignedBytes cooked_bytes_ = aligned("bank/cooked_tracks.mcpk");
  const AlignedBytes packed_bytes_ = aligned("bank/tiers.mcpk");
  std::optional<AlignedBytes> selection_bytes_;
  const mcpk_bank* cooked_ = nullptr;
  const mcpk_bank* packed_ = nullptr;
  const mcpr_selection* selection_ = nullptr;
};

TEST(RuntimeThreads, ShareClipsBanksAndSelections) {
  const Shared shared;
  const std::vector<float> expected = shared.played();
  std::vector<std::vector<float>> played(kThreads);
  {
    std::vector<std::jthread> threads;
    for (auto& one : played) threads.emplace_back([&] { one = shared.played(); });
  }
  for (const auto& one : played) EXPECT_EQ(one, expected);
}

}  // namespace
}  // namespace mocapress::threads_test
