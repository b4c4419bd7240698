// SPDX-License-Identifier: MIT
// Compares posing many characters together with posing them one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress {
namespace {

using test::CookedClip;
using test::OpenedClip;

/// A cooked clip, a selection of two of its joints, and a cursor.
class Stage {
 public:
  explicit Stage(const CompressedClip& clip)
      : cooked_(OpenedClip(write_container(clip)).clip),
        selection_memory_(mcpr_selection_bytes(cooked_.clip, 2)),
        cursor_memory_(mcpr_cursor_bytes(cooked_.clip)) {
    const std::uint16_t joints[] = {4, 1};
    EXPECT_EQ(mcpr_make_selection(cooked_.clip, joints, 2, selection_memory_.data(),
                                  selection_memory_.size(), &selection, nullptr),
              MCPR_OK);
  }

  const mcpr_cooked* clip() const { return cooked_.clip; }
  std::vector<float> sampled(const mcpr_sample_request& request, double time) const {
    return cooked_.sample(request, time);
  }
  /// A pose from a new cursor.
  std::vector<float> played(const mcpr_sample_request& request, double time) const {
    mcpr_cursor* cursor = nullptr;
    EXPECT_EQ(mcpr_make_cursor(cooked_.clip, cursor_memory_.data(), cursor_memory_.size(), &cursor,
                               nullptr),
              MCPR_OK);
    std::vector<float> out(mcpr_sample_values(cooked_.clip, &request));
    EXPECT_EQ(mcpr_sample_next(cursor, &request, time, out.data(), nullptr), MCPR_OK);
    return out;
  }

  const mcpr_selection* selection = nullptr;

 private:
  CookedClip cooked_;
  AlignedBytes selection_memory_;
  AlignedBytes cursor_memory_;
};

CompressedClip crowd_clip(int frames, EncodeSettings options = {}) {
  options.method = Method::ClosedLoop;
  options.target = {Target::Kind::Error, 0.1};
  return Encoder(test::smooth_motion(frames, static_cast<unsigned>(frames)))
      .encode(options)
      .compressed;
}

class PoseCrowd : public testing::Test {
 protected:
  PoseCrowd() {
    for (const int frames : {1, 2, 7, 33, 150, 257}) add(crowd_clip(frames));
    add(crowd_clip(90, {.loop = Loop::Repeats}));
    add(crowd_clip(80, {.loop = Loop::Follows}));
    add(crowd_clip(100, {.ends = Ends::Exact}));
    add(test::segmented_clip(test::smooth_motion(700),
                             {.frames = 700, .length = 300, .overlap = 48}));
  }

  void add(const CompressedClip& clip) { stages_.push_back(std::make_unique<Stage>(clip)); }

  struct Member {
    const Stage* stage;
    std::vector<float> out;
    mcpr_character character;

    mcpr_sample_request request(const mcpr_crowd_request& crowd) const {
      return {.layout = crowd.layout,
              .unit = crowd.unit,
              .wrap = character.wrap,
              .path = crowd.path,
              .selection = character.selection,
              .bands_left_out = character.bands_left_out,
              .stepped = character.stepped,
              .stepped_count = character.stepped_count};
    }
  };

  static constexpr std::uint16_t kStepped = 1;

  /// Characters at random instants of all clips, or close to one instant of each.
  std::vector<Member> members(int count, bool are_near, unsigned seed,
                              const mcpr_crowd_request& request) const {
    Random random(seed);
    std::vector<Member> made;
    for (int i = 0; i < count; ++i) {
      const Stage& stage = *stages_[static_cast<std::size_t>(random.below(stages_.size()))];
      const mcpr_cooked_info info = mcpr::describe(stage.clip());
      double time = (info.frames - 1) * (are_near ? 0.4 + 0.02 * random.unit() : random.unit());
      if (i % 5 == 0) time = std::floor(time);
      const bool loops = info.loop_frames > 0 && i % 2 == 0;
      if (loops) time = 3.0 * (time - info.frames);
      if (request.unit == MCPR_SECONDS) time /= info.sample_rate;
      Member member{&stage, {}, {}};
      member.character = {.clip = stage.clip(),
                          .selection = i % 7 == 0 ? stage.selection : nullptr,
                          .time = time,
                          .out = nullptr,
                          .wrap = loops ? MCPR_LOOP : MCPR_CLAMP,
                          .bands_left_out = i % 3 == 0 ? static_cast<std::uint32_t>(i) % 4 : 0,
                          .stepped = i % 11 == 0 ? &kStepped : nullptr,
                          .stepped_count = i % 11 == 0 ? 1U : 0U};
      const mcpr_sample_request one = member.request(request);
      member.out.assign(mcpr_sample_values(stage.clip(), &one) + 1, -7.0F);
      made.push_back(std::move(member));
    }
    return made;
  }

  static std::vector<mcpr_character> characters_of(std::vector<Member>& members) {
    std::vector<mcpr_character> characters;
    for (Member& member : members) {
      member.character.out = member.out.data();
      characters.push_back(member.character);
    }
    return characters;
  }

  static mcpr_result sort(const mcpr_crowd_request& request,
                          std::vector<mcpr_character>& characters) {
    const auto count = static_cast<std::uint32_t>(characters.size());
    const AlignedBytes scratch(mcpr_sort_crowd_scratch_bytes(count));
    mcpr_result result;
    mcpr_sort_crowd(&request, characters.data(), count, scratch.data(), scratch.size(), &result);
    return result;
  }

  static mcpr_result pose(const mcpr_crowd_request& request,
                          const std::vector<mcpr_character>& characters) {
    const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
    mcpr_result result;
    mcpr_sample_crowd(&request, characters.data(), static_cast<std::uint32_t>(characters.size()),
                      scratch.data(), scratch.size(), &result);
    return result;
  }

  std::vector<std::unique_ptr<Stage>> stages_;
};

TEST_F(PoseCrowd, MatchesSamplesToTheBitOnRequest) {
  for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS, MCPR_MATRICES})
    for (const mcpr_time unit : {MCPR_FRAMES, MCPR_SECONDS}) {
      const mcpr_crowd_request request{.layout = layout, .unit = unit, .exact = 1};
      std::vector<Member> all = members(700, layout == MCPR_ARRAYS, 3, request);
      std::vector<mcpr_character> characters = characters_of(all);
      ASSERT_EQ(sort(request, characters).status, MCPR_OK);
      ASSERT_EQ(pose(request, characters).status, MCPR_OK);
      for (Member& member : all) {
        EXPECT_EQ(member.out.back(), -7) << "nothing beyond";
        member.out.pop_back();
        EXPECT_EQ(member.out,
                  member.stage->sampled(member.request(request), member.character.time));
      }
    }
}

/// Tests all paths, sorted and unsorted. Where instants are dense, most poses have a cursor's bits.
TEST_F(PoseCrowd, MatchesSamplesOrCursorsToTheBit) {
  for (const bool are_near : {false, true})
    for (const bool are_sorted : {false, true}) {
      std::vector<std::vector<float>> of_paths;
      for (const mcpr_path path : existing_paths()) {
        const mcpr_crowd_request request{.path = path};
        std::vector<Member> all = members(900, are_near, 4, request);
        std::vector<mcpr_character> characters = characters_of(all);
        if (are_sorted) {
          ASSERT_EQ(sort(request, characters).status, MCPR_OK);
        }
        ASSERT_EQ(pose(request, characters).status, MCPR_OK);
        int sampled = 0;
        int played = 0;
        std::vector<float> together;
        for (Member& member : all) {
          member.out.pop_back();
          const mcpr_sample_request one = member.request(request);
          const bool is_sampled = member.out == member.stage->sampled(one, member.character.time);
          const bool is_played = member.out == member.stage->played(one, member.character.time);
          EXPECT_TRUE(is_sampled || is_played) << member.character.time;
          sampled += is_sampled ? 1 : 0;
          played += is_played && !is_sampled ? 1 : 0;
          together.insert(together.end(), member.out.begin(), member.out.end());
        }
        of_paths.push_back(together);
        if (are_near && are_sorted) {
          EXPECT_GT(played, 200) << "frames are lifted for many";
        }
        EXPECT_GT(sampled, 0);
      }
      EXPECT_EQ(of_paths[0], of_paths[1]);
    }
}

TEST_F(PoseCrowd, SortsByClipAndInstantWithoutLosingAny) {
  const mcpr_crowd_request request{};
  std::vector<Member> all = members(3000, false, 5, request);
  std::vector<mcpr_character> characters = characters_of(all);
  ASSERT_EQ(sort(request, characters).status, MCPR_OK);
  std::vector<const void*> before;
  std::vector<const void*> after;
  for (const Member& member : all) before.push_back(member.out.data());
  for (std::size_t i = 0; i < characters.size(); ++i) {
    after.push_back(characters[i].out);
    if (i == 0 || characters[i].clip != characters[i - 1].clip) continue;
    ASSERT_GE(characters[i].bands_left_out, characters[i - 1].bands_left_out);
    if (characters[i].bands_left_out == characters[i - 1].bands_left_out &&
        characters[i].wrap == MCPR_CLAMP && characters[i - 1].wrap == MCPR_CLAMP) {
      EXPECT_GE(characters[i].time, characters[i - 1].time - 1);
    }
  }
  std::ranges::sort(before);
  std::ranges::sort(after);
  EXPECT_EQ(before, after);
  std::vector<mcpr_character> again = characters;
  ASSERT_EQ(sort(request, again).status, MCPR_OK);
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].out, characters[i].out);
}

TEST_F(PoseCrowd, RefusesAllIfOneCannotBePosed) {
  const mcpr_crowd_request request{};
  std::vector<Member> all = members(50, false, 6, request);
  const std::vector<mcpr_character> good = characters_of(all);
  const auto refused_for = [&](const auto& spoil) {
    std::vector<mcpr_character> characters = good;
    spoil(characters[31]);
    const mcpr_result result = pose(request, characters);
    EXPECT_EQ(result.status, MCPR_ARGUMENT);
    EXPECT_EQ(result.offset, 31u);
    EXPECT_EQ(sort(request, characters).offset, 31u);
    for (const Member& member : all) EXPECT_EQ(member.out[0], -7);
  };
  refused_for([](mcpr_character& c) { c.clip = nullptr; });
  refused_for([](mcpr_character& c) { c.out = nullptr; });
  refused_for([](mcpr_character& c) { c.time = std::nan(""); });
  refused_for([](mcpr_character& c) { c.bands_left_out = MCPR_MOST_BANDS_LEFT_OUT + 1; });
  refused_for([&](mcpr_character& c) {  // not a loop
    c.clip = stages_[3]->clip();
    c.selection = nullptr;
    c.wrap = MCPR_LOOP;
  });
  refused_for([&](mcpr_character& c) {
    for (const auto& stage : stages_)
      if (stage->clip() != c.clip) c.selection = stage->selection;
  });
  EXPECT_EQ(mcpr_sample_crowd(nullptr, good.data(), 1, nullptr, 0, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_sample_crowd(&request, nullptr, 1, nullptr, 0, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_sample_crowd(&request, nullptr, 0, nullptr, 0, nullptr), MCPR_OK) << "of none";
  const AlignedBytes scratch(mcpr_crowd_scratch_bytes());
  EXPECT_EQ(
      mcpr_sample_crowd(&request, good.data(), 1, scratch.data(), scratch.size() - 1, nullptr),
      MCPR_MEMORY);
  EXPECT_EQ(mcpr_sort_crowd(&request, const_cast<mcpr_character*>(good.data()), 50, scratch.data(),
                            99, nullptr),
            MCPR_MEMORY);
}

}  // namespace
}  // namespace mocapress
