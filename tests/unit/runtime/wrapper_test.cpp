// SPDX-License-Identifier: MIT
// The header for C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/file.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/own_memory.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"

namespace mocapress::wrapper_test {
namespace {

std::vector<std::byte> bytes_of(const std::string& name) {
  return read_bytes(std::string(MOCAPRESS_SOURCE_DIR) + "/tests/fuzz/corpus/" + name);
}

std::vector<float> values_of(const std::vector<mcpr_transform>& pose) {
  std::vector<float> values(8 * pose.size());
  std::memcpy(values.data(), pose.data(), sizeof(float) * values.size());
  return values;
}

TEST(RuntimeInCxx, LoadsTheClipsOfTheCFunctions) {
  const std::vector<std::byte> file = bytes_of("runtime/segments.mcpr");
  const test::OpenedClip opened(file);
  const auto clip = mcpr::load(file);
  ASSERT_TRUE(clip) << clip.result.message;
  EXPECT_EQ(mcpr_skeleton_hash(clip->get()), mcpr_skeleton_hash(opened.clip));
  EXPECT_EQ(mcpr::describe(clip->get()).frames, opened.info.frames);
  const auto cooked = mcpr::load_cooked(file, {.skeleton = 1});
  ASSERT_TRUE(cooked) << cooked.result.message;
  EXPECT_EQ(mcpr_cooked_skeleton_hash(cooked->get()), mcpr_skeleton_hash(opened.clip));
}

TEST(RuntimeInCxx, APlayerGivesTheBitsOfItsCursor) {
  const test::OpenedClip opened(bytes_of("runtime/segments.mcpr"));
  const test::CookedClip cooked(opened.clip);
  auto player = mcpr::Player::of(cooked.clip);
  ASSERT_TRUE(player) << player.result.message;
  const AlignedBytes memory(mcpr_cursor_bytes(cooked.clip));
  mcpr_cursor* cursor = nullptr;
  ASSERT_EQ(mcpr_make_cursor(cooked.clip, memory.data(), memory.size(), &cursor, nullptr), MCPR_OK);
  std::vector<mcpr_transform> pose(mcpr::describe(cooked.clip).joints);
  const mcpr_sample_request request{.unit = MCPR_SECONDS, .wrap = MCPR_PING_PONG};
  for (double seconds = 0; seconds < 20; seconds += 0.37) {
    ASSERT_EQ(player->sample(seconds, pose, MCPR_PING_PONG).status, MCPR_OK);
    std::vector<float> expected(8 * pose.size());
    ASSERT_EQ(mcpr_sample_next(cursor, &request, seconds, expected.data(), nullptr), MCPR_OK);
    EXPECT_EQ(values_of(pose), expected) << seconds;
  }
}

TEST(RuntimeInCxx, APlayerFindsTheMemoryThatALargeClipNeeds) {
  const test::OpenedClip opened(bytes_of("runtime/many_joints.mcpr"));
  const test::CookedClip cooked(opened.clip);
  auto player = mcpr::Player::of(cooked.clip);
  const std::uint16_t root = 0;
  mcpr_sample_request request{.layout = MCPR_MATRICES};
  ASSERT_GT(mcpr_sample_scratch_bytes(cooked.clip, &request), 0U);
  std::vector<float> out(mcpr_sample_values(cooked.clip, &request));
  EXPECT_EQ(player->sample(request, 3.5, out).status, MCPR_OK);
  request.stepped = &root;
  request.stepped_count = 1;
  EXPECT_EQ(player->sample(request, 3.5, out).status, MCPR_OK) << "more memory than before";
}

TEST(RuntimeInCxx, APlayerMayBeMoved) {
  const auto clip = mcpr::load_cooked(bytes_of("runtime/segments.mcpr"));
  auto made = mcpr::Player::of(clip->get());
  mcpr::Player player = std::move(*made);
  std::vector<mcpr_transform> pose(mcpr::describe(clip->get()).joints);
  EXPECT_EQ(player.sample(0.1, pose).status, MCPR_OK);
}

TEST(RuntimeInCxx, RoomThatIsTooSmallIsRefused) {
  const auto clip = mcpr::load_cooked(bytes_of("runtime/segments.mcpr"));
  auto player = mcpr::Player::of(clip->get());
  ASSERT_TRUE(player);
  std::vector<mcpr_transform> pose(mcpr::describe(clip->get()).joints - 1);
  EXPECT_EQ(player->sample(0, pose).status, MCPR_MEMORY);
  EXPECT_EQ(player->sample(0, {}).status, MCPR_MEMORY);
}

TEST(RuntimeInCxx, AFailureIsEmptyAndSaysWhy) {
  std::vector<std::byte> file = bytes_of("runtime/segments.mcpr");
  file.pop_back();
  const auto clip = mcpr::load(file);
  EXPECT_FALSE(clip);
  EXPECT_EQ(clip.value, nullptr);
  EXPECT_EQ(clip.result.status, MCPR_DAMAGED);
  const auto cooked = mcpr::load_cooked(file);
  EXPECT_FALSE(cooked);
  EXPECT_EQ(cooked.value, nullptr);
  EXPECT_FALSE(mcpr::Player::of(nullptr));
  EXPECT_EQ(mcpr::open_bank({}).result.status, MCPR_NO_MEMORY);
  mcpr::Player none;
  EXPECT_EQ(none.sample(0, {}).status, MCPR_ARGUMENT);
}

TEST(RuntimeInCxx, CountsTheTiersThatHaveCome) {
  const std::vector<std::byte> file = bytes_of("runtime/tiers.mcpr");
  std::vector<std::size_t> ends;
  mcpr_tier tier;
  while (mcpr_tier_of(file.data(), file.size(), static_cast<std::uint32_t>(ends.size()), &tier,
                      nullptr) == MCPR_OK)
    ends.push_back(tier.bytes);
  ASSERT_GT(ends.size(), 1U);
  EXPECT_EQ(ends.back(), file.size());
  for (std::size_t size = 0; size <= file.size(); ++size) {
    const std::span<const std::byte> come(file.data(), size);
    const auto whole =
        std::count_if(ends.begin(), ends.end(), [&](auto end) { return end <= size; });
    ASSERT_EQ(mcpr::tiers_within(come), static_cast<std::uint32_t>(whole)) << size;
  }
  mcpr_limits limits = mcpr::default_limits();
  limits.tiers = 1;
  EXPECT_TRUE(mcpr::load(std::span(file).first(ends[0]), &limits));
  EXPECT_EQ(mcpr::tiers_within(bytes_of("runtime/segments.mcpr")), 0U);
}

TEST(RuntimeInCxx, LoadsAndCooksClipsOfAPackedBank) {
  const std::vector<std::byte> file = bytes_of("bank/tiers.mcpk");
  const AlignedBytes memory(file.size());
  std::copy(file.begin(), file.end(), memory.data());
  const auto bank = mcpr::open_bank({memory.data(), memory.size()});
  ASSERT_TRUE(bank) << bank.result.message;
  mcpr_limits limits = mcpr::default_limits();
  std::vector<float> poses[2];
  for (limits.tiers = 1; limits.tiers <= 2; ++limits.tiers) {
    const auto clip = mcpr::load(bank.value, 0, &limits);
    ASSERT_TRUE(clip) << clip.result.message;
    const auto cooked = mcpr::load_cooked(bank.value, 0, {}, &limits);
    ASSERT_TRUE(cooked) << cooked.result.message;
    std::vector<mcpr_transform> pose(mcpr::describe(cooked->get()).joints);
    ASSERT_EQ(mcpr::Player::of(cooked->get())->sample({}, 2.5, pose).status, MCPR_OK);
    poses[limits.tiers - 1] = values_of(pose);
    const test::CookedClip expected(clip->get());
    ASSERT_EQ(mcpr::Player::of(expected.clip)->sample({}, 2.5, pose).status, MCPR_OK);
    EXPECT_EQ(poses[limits.tiers - 1], values_of(pose));
  }
  EXPECT_NE(poses[0], poses[1]);
  EXPECT_EQ(mcpr::load_cooked(bank.value, 1000).result.status, MCPR_ARGUMENT);
  EXPECT_EQ(mcpr::load(nullptr, 0).result.status, MCPR_ARGUMENT);
}

TEST(RuntimeInCxx, FindsAndNamesClipsOfABank) {
  const std::vector<std::byte> file = bytes_of("bank/cooked_tracks.mcpk");
  const AlignedBytes memory(file.size());
  std::copy(file.begin(), file.end(), memory.data());
  const auto bank = mcpr::open_bank({memory.data(), memory.size()});
  ASSERT_TRUE(bank) << bank.result.message;
  const std::uint32_t clips = mcpr::describe(bank.value).clips;
  ASSERT_GT(clips, 1U);
  for (std::uint32_t clip = 0; clip < clips; ++clip) {
    const mcpr::Name name(bank.value, clip);
    const mcpr_cooked* expected = nullptr;
    ASSERT_EQ(mcpk_cooked(bank.value, clip, &expected, nullptr), MCPR_OK);
    EXPECT_EQ(mcpr::cooked_of(bank.value, name.text).value, expected);
    EXPECT_TRUE(mcpr::Player::of(expected));
  }
  EXPECT_EQ(std::string_view(mcpr::Name(bank.value, clips)), "");
  const auto none = mcpr::cooked_of(bank.value, "nowhere");
  EXPECT_EQ(none.value, nullptr);
  EXPECT_STREQ(none.result.message, "the bank has no clip of this name");
}

}  // namespace
}  // namespace mocapress::wrapper_test
