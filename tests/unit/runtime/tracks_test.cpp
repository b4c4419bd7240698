// SPDX-License-Identifier: MIT
// The C interface to tracks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <utility>

#include "core/base/random.h"
#include "core/codec/decode/track_decoding.h"
#include "core/codec/encode/track_encoder.h"
#include "core/codec/format/container.h"
#include "core/runtime/mocapress_runtime.hpp"
#include "core/runtime/pose/cooked_check.h"
#include "tests/fuzz/file_sections.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/some_tracks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

using test::OpenedClip;

constexpr int kTrackFrames = 700;  // spans more than two segments of 256

class RuntimeTracks : public testing::Test {
 protected:
  static std::vector<std::byte> file(Loop loop = Loop::None) {
    CompressedClip clip =
        test::segmented_clip(test::smooth_motion(kTrackFrames), {kTrackFrames, 300, 20});
    clip.loop = loop;
    return with_tracks(write_container(clip), test::some_tracks(kTrackFrames), 0.002);
  }

  static std::vector<float> frames(const OpenedClip& clip, const mcpr_track_request& request,
                                   std::uint32_t first, std::uint32_t count) {
    const AlignedBytes scratch(mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &request));
    std::vector<float> out(count * mcpr_track_values(mcpr_clip_tracks(clip.clip), &request));
    EXPECT_EQ(mcpr_track_frames(mcpr_clip_tracks(clip.clip), &request, first, count, out.data(),
                                scratch.data(), scratch.size(), nullptr),
              MCPR_OK);
    return out;
  }

  static std::vector<float> moment(const OpenedClip& clip, const mcpr_track_request& request,
                                   double frame) {
    const AlignedBytes scratch(mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &request));
    std::vector<float> out(mcpr_track_values(mcpr_clip_tracks(clip.clip), &request));
    if (mcpr_track_moment(mcpr_clip_tracks(clip.clip), &request, frame, out.data(), scratch.data(),
                          scratch.size(), nullptr) != MCPR_OK)
      out.clear();
    return out;
  }
};

TEST_F(RuntimeTracks, AreListedAndFound) {
  const OpenedClip clip(file());
  ASSERT_NE(clip.clip, nullptr) << clip.result.message;
  const ScalarTracks tracks = test::some_tracks(kTrackFrames);
  ASSERT_EQ(mcpr::describe(clip.clip).tracks, tracks.size());
  for (std::uint32_t t = 0; t < tracks.size(); ++t) {
    mcpr_track track;
    ASSERT_EQ(mcpr_track_describe(mcpr_clip_tracks(clip.clip), t, &track, nullptr), MCPR_OK);
    EXPECT_EQ(track.node, tracks[t].node);
    EXPECT_EQ(track.name, tracks[t].name);
    EXPECT_EQ(static_cast<int>(track.kind), static_cast<int>(tracks[t].kind));
    EXPECT_EQ(track.steps != 0, tracks[t].steps);
  }
  EXPECT_EQ(mcpr_find_track(mcpr_clip_tracks(clip.clip), MCPR_TRACK_MORPH_WEIGHT, "Face", "frown"),
            3);
  EXPECT_EQ(mcpr_find_track(mcpr_clip_tracks(clip.clip), MCPR_TRACK_MORPH_WEIGHT, nullptr, "frown"),
            3);
  EXPECT_EQ(mcpr_find_track(mcpr_clip_tracks(clip.clip), MCPR_TRACK_SCALE_Y, "spine", nullptr), 4);
  EXPECT_EQ(mcpr_find_track(mcpr_clip_tracks(clip.clip), MCPR_TRACK_PROPERTY, "Face", "frown"), -1);
  EXPECT_EQ(mcpr_find_track(mcpr_clip_tracks(clip.clip), MCPR_TRACK_PROPERTY, "Face", nullptr), -1);
}

TEST_F(RuntimeTracks, MatchTheLibraryToTheBit) {
  const OpenedClip clip(file());
  const ScalarTracks tracks = tracks_of(file());
  const std::vector<float> all = frames(clip, {}, 0, kTrackFrames);
  for (std::size_t t = 0; t < tracks.size(); ++t)
    for (std::size_t f = 0; f < kTrackFrames; ++f)
      ASSERT_EQ(all[f * tracks.size() + t], tracks[t].values[f]) << label(tracks[t]) << ' ' << f;
  // Decodes in pieces, and subsets of tracks.
  const std::uint16_t some[] = {4, 1, 0};
  for (const auto& [first, count] : {std::pair{0U, 1U}, {699U, 1U}, {250U, 200U}, {17U, 3U}}) {
    const std::vector<float> part = frames(clip, {some, 3}, first, count);
    for (std::uint32_t f = 0; f < count; ++f)
      for (std::size_t i = 0; i < 3; ++i)
        ASSERT_EQ(part[3 * f + i], all[(first + f) * tracks.size() + some[i]]);
  }
}

TEST_F(RuntimeTracks, InterpolateOrHoldBetweenFrames) {
  const OpenedClip clip(file());
  const std::vector<float> two = frames(clip, {}, 84, 2);  // around the frame where the switch
                                                           // turns on
  const std::vector<float> between = moment(clip, {}, 84.25);
  for (std::size_t t = 0; t < 5; ++t) {
    const float linear = two[t] + 0.25F * (two[5 + t] - two[t]);
    EXPECT_EQ(between[t], t == 0 ? two[0] : linear) << t;
  }
  EXPECT_NE(two[0], two[5]);
  EXPECT_EQ(moment(clip, {}, 84), std::vector<float>(two.begin(), two.begin() + 5));
  EXPECT_TRUE(moment(clip, {}, std::nan("")).empty());
  EXPECT_EQ(moment(clip, {}, -0.01), frames(clip, {}, 0, 1));
  EXPECT_EQ(moment(clip, {}, kTrackFrames + 7.5), frames(clip, {}, kTrackFrames - 1, 1));
  EXPECT_EQ(moment(clip, {.sample_rate = 120}, 84.25 / 120), between);
}

TEST_F(RuntimeTracks, WrapInALoopWithoutARepeatedFrame) {
  const OpenedClip clip(file(Loop::Follows));
  const std::vector<float> last = frames(clip, {}, kTrackFrames - 1, 1);
  const std::vector<float> first = frames(clip, {}, 0, 1);
  const mcpr_track_request looping{.wrap = MCPR_LOOP};
  const std::vector<float> across = moment(clip, looping, kTrackFrames - 0.5);
  for (std::size_t t = 1; t < 5; ++t) EXPECT_EQ(across[t], last[t] + 0.5F * (first[t] - last[t]));
  EXPECT_EQ(moment(clip, looping, kTrackFrames), first);
  EXPECT_TRUE(moment(OpenedClip(file()), looping, 0).empty());
}

TEST_F(RuntimeTracks, WrapAsTheCallerWants) {
  const OpenedClip clip(file());
  const auto at = [&](mcpr_wrap wrap, double frame) { return moment(clip, {.wrap = wrap}, frame); };
  const double last = kTrackFrames - 1;
  EXPECT_EQ(at(MCPR_PING_PONG, last + 3.25), at(MCPR_CLAMP, last - 3.25));
  EXPECT_EQ(at(MCPR_PING_PONG, -3.25), at(MCPR_CLAMP, 3.25));
  EXPECT_EQ(at(MCPR_LOOP_JUMP, last), at(MCPR_CLAMP, 0));
  EXPECT_EQ(at(MCPR_LOOP_JUMP, last + 84.5), at(MCPR_CLAMP, 84.5));
  EXPECT_EQ(at(MCPR_LOOP_HOLD, last + 0.75), at(MCPR_CLAMP, last));
  EXPECT_EQ(at(MCPR_LOOP_HOLD, last + 1), at(MCPR_CLAMP, 0));
  const std::vector<float> before = at(MCPR_CLAMP, last);
  const std::vector<float> after = at(MCPR_CLAMP, 0);
  const std::vector<float> across = at(MCPR_LOOP_BLEND, last + 0.5);
  for (std::size_t t = 1; t < 5; ++t)
    EXPECT_EQ(across[t], before[t] + 0.5F * (after[t] - before[t]));
}

/// Changes between two instants, found one frame after the other.
std::vector<std::pair<double, float>> changes_of(const OpenedClip& clip,
                                                 const mcpr_track_request& request, double from,
                                                 double to) {
  const mcpr_tracks* const tracks = mcpr_clip_tracks(clip.clip);
  std::uint32_t count = 0;
  EXPECT_EQ(mcpr_track_changes(tracks, &request, from, to, nullptr, 0, &count, nullptr), MCPR_OK);
  std::vector<mcpr_change> changes(count);
  EXPECT_EQ(mcpr_track_changes(tracks, &request, from, to, changes.data(), count, &count, nullptr),
            MCPR_OK);
  std::vector<std::pair<double, float>> found;
  for (const mcpr_change& change : changes) {
    mcpr_track track;
    EXPECT_EQ(mcpr_track_describe(tracks, change.track, &track, nullptr), MCPR_OK);
    EXPECT_EQ(track.steps, 1);
    found.emplace_back(change.time, change.value);
  }
  return found;
}

TEST_F(RuntimeTracks, TellWhichSwitchesChangedBetweenTwoInstants) {
  const OpenedClip clip(file());
  const std::vector<float> all = frames(clip, {}, 0, kTrackFrames);
  std::vector<std::pair<double, float>> expected;
  for (std::size_t f = 1; f < kTrackFrames; ++f)
    if (all[5 * f] != all[5 * (f - 1)]) expected.emplace_back(f, all[5 * f]);
  ASSERT_GE(expected.size(), 2U);
  EXPECT_EQ(changes_of(clip, {}, 0, kTrackFrames + 100), expected);
  // In pieces, each change once, whether an instant is a frame or not.
  for (const double step : {0.3, 1.0, 7.0}) {
    std::vector<std::pair<double, float>> found;
    for (double at = 0; at < kTrackFrames; at += step) {
      const auto now = changes_of(clip, {}, at, at + step);
      found.insert(found.end(), now.begin(), now.end());
    }
    EXPECT_EQ(found, expected) << step;
  }
  // Backwards, in the opposite order, to the values before.
  const auto back = changes_of(clip, {}, kTrackFrames, 0);
  ASSERT_EQ(back.size(), expected.size());
  for (std::size_t i = 0; i < back.size(); ++i) {
    const auto frame = static_cast<std::size_t>(back[i].first);
    EXPECT_EQ(back[i].first, expected[expected.size() - 1 - i].first);
    EXPECT_EQ(back[i].second, all[5 * (frame - 1)]);
  }
  // In seconds, and over cycles: what changed in the first comes back in the second, a clip later.
  const auto seconds = changes_of(clip, {.sample_rate = 120}, 0, kTrackFrames / 120.0);
  ASSERT_EQ(seconds.size(), expected.size());
  EXPECT_EQ(seconds[0].first, expected[0].first / 120);
  // A moment at the time of a change has its value, as times in seconds round.
  const mcpr_track_request at_60{.sample_rate = 60};
  for (const auto& [time, value] : changes_of(clip, at_60, 0, kTrackFrames / 60.0))
    EXPECT_EQ(moment(clip, at_60, time)[0], value) << time;
  EXPECT_EQ(changes_of(clip, {}, expected[0].first, expected[0].first - 0.5).size(), 1U);
  EXPECT_EQ(changes_of(clip, {}, expected[0].first + 0.5, expected[0].first).size(), 0U);
  const auto cycles =
      changes_of(clip, {.wrap = MCPR_LOOP_HOLD}, kTrackFrames + 1, 2 * kTrackFrames - 1);
  ASSERT_EQ(cycles.size(), expected.size());
  EXPECT_EQ(cycles[0].first, expected[0].first + kTrackFrames);
  const auto mirrored =
      changes_of(clip, {.wrap = MCPR_PING_PONG}, kTrackFrames - 1, 2 * kTrackFrames - 2);
  EXPECT_EQ(mirrored.size(), expected.size());
}

TEST_F(RuntimeTracks, RefuseChangesOfTooManyFrames) {
  const OpenedClip clip(file());
  const mcpr_track_request all{};
  std::uint32_t count = 0;
  for (const double to : {1e9, HUGE_VAL, std::nan("")})
    EXPECT_EQ(
        mcpr_track_changes(mcpr_clip_tracks(clip.clip), &all, 0, to, nullptr, 0, &count, nullptr),
        MCPR_ARGUMENT);
  const mcpr_track_request fast{.sample_rate = 1e10};
  EXPECT_EQ(mcpr_track_changes(mcpr_clip_tracks(clip.clip), &fast, 1e300, 1e305, nullptr, 0, &count,
                               nullptr),
            MCPR_ARGUMENT);
  EXPECT_EQ(
      mcpr_track_changes(mcpr_clip_tracks(clip.clip), &all, 0, 1, nullptr, 0, nullptr, nullptr),
      MCPR_ARGUMENT);
}

/// Beyond 2^52 nothing lies between two frames.
TEST_F(RuntimeTracks, RefuseChangesWhereFramesHaveNothingBetween) {
  const OpenedClip clip(file());
  const mcpr_track_request all{};
  std::uint32_t count = 0;
  const auto status = [&](double from, double to) {
    return mcpr_track_changes(mcpr_clip_tracks(clip.clip), &all, from, to, nullptr, 0, &count,
                              nullptr);
  };
  EXPECT_EQ(status(0x1p52 - 4, 0x1p52), MCPR_OK);
  EXPECT_EQ(status(0x1p53, 0x1p53 + 8), MCPR_ARGUMENT);
  EXPECT_EQ(status(-0x1p53 - 8, -0x1p53), MCPR_ARGUMENT);
}

TEST_F(RuntimeTracks, RefuseASampleRateBelowZero) {
  const OpenedClip clip(file());
  for (const double rate : {-30.0, std::nan("")}) {
    const mcpr_track_request request{.sample_rate = rate};
    EXPECT_EQ(mcpr_track_values(mcpr_clip_tracks(clip.clip), &request), 0U);
  }
}

TEST_F(RuntimeTracks, ImpossibleCallsAreRefused) {
  const OpenedClip clip(file());
  std::vector<float> out(5);
  const AlignedBytes scratch(1 << 20);
  const auto status = [&](const mcpr_track_request& request, std::uint32_t first,
                          std::size_t size) {
    return mcpr_track_frames(mcpr_clip_tracks(clip.clip), &request, first, 1, out.data(),
                             scratch.data(), size, nullptr);
  };
  const std::uint16_t twice[] = {1, 1};
  const std::uint16_t beyond[] = {5};
  EXPECT_EQ(status({twice, 2}, 0, scratch.size()), MCPR_ARGUMENT);
  EXPECT_EQ(status({beyond, 1}, 0, scratch.size()), MCPR_ARGUMENT);
  EXPECT_EQ(status({nullptr, 1}, 0, scratch.size()), MCPR_ARGUMENT);
  EXPECT_EQ(status({}, kTrackFrames, scratch.size()), MCPR_ARGUMENT);
  const mcpr_track_request all{};
  EXPECT_EQ(status(all, 0, mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &all) - 1),
            MCPR_MEMORY);
  EXPECT_EQ(status(all, 0, mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &all)), MCPR_OK);
  mcpr_track track;
  EXPECT_EQ(mcpr_track_describe(mcpr_clip_tracks(clip.clip), 5, &track, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_track_describe(nullptr, 0, &track, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_find_track(nullptr, MCPR_TRACK_PROPERTY, nullptr, nullptr), -1);
}

TEST_F(RuntimeTracks, EveryChangedByteIsRefusedOrPlays) {
  const CompressedClip clip =
      test::segmented_clip(test::smooth_motion(60), SegmentLayout::whole(60));
  const std::vector<std::byte> plain = write_container(clip);
  const std::vector<std::byte> whole = with_coded_tracks(plain, test::some_coded_tracks(60));
  Random random(9);
  int refused = 0;
  for (std::size_t at = plain.size(); at < whole.size(); ++at) {
    std::vector<std::byte> changed = whole;
    changed[at] ^= static_cast<std::byte>(1 + random.below(255));
    test::mend_checksums(changed);
    const OpenedClip opened(changed);
    if (opened.clip == nullptr) {
      ++refused;
      continue;
    }
    const std::uint32_t tracks = mcpr::describe(opened.clip).tracks;
    EXPECT_EQ(opened.tracks(30, 30).size(), 30 * tracks);
  }
  EXPECT_GT(refused, 20);
}

TEST_F(RuntimeTracks, SurviveCookingToTheBit) {
  for (const Loop loop : {Loop::None, Loop::Follows}) {
    const OpenedClip clip(file(loop));
    const test::CookedClip cooked(clip.clip);
    const mcpr_cooked* opened = nullptr;
    ASSERT_EQ(mcpr_open_cooked(cooked.bytes->data(), cooked.bytes->size(), 1, &opened, nullptr),
              MCPR_OK);
    const mcpr_tracks* const tracks = mcpr_cooked_tracks(opened);
    EXPECT_EQ(mcpr_track_count(tracks), 5u);
    EXPECT_EQ(mcpr_find_track(tracks, MCPR_TRACK_MORPH_WEIGHT, "Face", "frown"), 3);
    EXPECT_EQ(OpenedClip::frames_of(tracks, 0, kTrackFrames), clip.tracks(0, kTrackFrames));
  }
}

/// Changes every byte of a cooked clip's tracks, and updates the checksum. Each result is refused
/// or played without harm (run under asan).
TEST_F(RuntimeTracks, EveryChangedByteOfACookedClipIsRefusedOrPlays) {
  const OpenedClip clip(with_tracks(
      write_container(test::segmented_clip(test::smooth_motion(300), SegmentLayout::whole(300))),
      test::some_tracks(300), 0.002));
  const test::CookedClip cooked(clip.clip);
  const std::size_t size = cooked.bytes->size();
  const auto* const tracks = reinterpret_cast<const std::byte*>(mcpr_cooked_tracks(cooked.clip));
  const auto first = static_cast<std::size_t>(tracks - cooked.bytes->data());
  const AlignedBytes copy(size);
  Random random(4);
  int refused = 0;
  int played = 0;
  for (std::size_t at = first; at < size; ++at)
    for (int round = 0; round < 8; ++round) {
      std::memcpy(copy.data(), cooked.bytes->data(), size);
      copy.data()[at] ^= static_cast<std::byte>(round == 0 ? 0xFF : 1 + random.below(255));
      auto* const head = reinterpret_cast<mcpr_cooked*>(copy.data());
      head->checksum = runtime::checksum_of(*head);
      const mcpr_cooked* opened = nullptr;
      if (mcpr_open_cooked(copy.data(), size, 1, &opened, nullptr) != MCPR_OK) {
        ++refused;
        continue;
      }
      ++played;
      OpenedClip::frames_of(mcpr_cooked_tracks(opened), 0, 300);
    }
  EXPECT_GT(refused, 500);
  EXPECT_GT(played, 500);
}

TEST_F(RuntimeTracks, AreNullForAClipWithoutTracks) {
  const OpenedClip clip(
      write_container(test::segmented_clip(test::smooth_motion(50), SegmentLayout::whole(50))));
  const mcpr_track_request all{};
  EXPECT_EQ(mcpr::describe(clip.clip).tracks, 0u);
  EXPECT_EQ(mcpr_clip_tracks(clip.clip), nullptr);
  EXPECT_EQ(mcpr_cooked_tracks(test::CookedClip(clip.clip).clip), nullptr);
  EXPECT_EQ(mcpr_cooked_tracks(nullptr), nullptr);
  EXPECT_EQ(mcpr_track_values(mcpr_clip_tracks(clip.clip), &all), 0u);
  EXPECT_EQ(mcpr_track_scratch_bytes(mcpr_clip_tracks(clip.clip), &all), 0u);
}

}  // namespace
}  // namespace mocapress
