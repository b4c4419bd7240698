// SPDX-License-Identifier: MIT
// Compares playing through a cursor with sampling without one.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/runtime/pose/cooked_check.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_cursor.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress {
namespace {

using test::CookedClip;
using test::OpenedClip;

// Both are within SAMPLING.md's bounds of the decoder, so they may differ by twice these.
constexpr double kTurnBetween = 2 * 5e-4;   // radians
constexpr double kShiftBetween = 2 * 2e-3;  // cm

CompressedClip clip_of_frames(int frames, EncodeSettings options = {}) {
  options.method = Method::ClosedLoop;
  return Encoder(test::smooth_motion(frames, static_cast<unsigned>(frames)))
      .encode(options)
      .compressed;
}

/// A cooked clip with its own cursor.
class Player {
 public:
  explicit Player(const CompressedClip& clip)
      : Player(std::make_unique<CookedClip>(OpenedClip(write_container(clip)).clip)) {}

  const CookedClip& clip() const { return *clip_; }

  std::vector<float> next(const mcpr_sample_request& request, double time) {
    return sample_with(cursor_, request, time);
  }
  /// A pose from a new cursor.
  std::vector<float> fresh(const mcpr_sample_request& request, double time) const {
    const AlignedBytes memory(mcpr_cursor_bytes(clip_->clip));
    mcpr_cursor* cursor = nullptr;
    EXPECT_EQ(mcpr_make_cursor(clip_->clip, memory.data(), memory.size(), &cursor, nullptr),
              MCPR_OK);
    return sample_with(cursor, request, time);
  }

 private:
  explicit Player(std::unique_ptr<CookedClip> clip)
      : clip_(std::move(clip)), memory_(mcpr_cursor_bytes(clip_->clip)) {
    EXPECT_LE(memory_.size(), mcpr_cursor::kMostBytes);
    EXPECT_EQ(mcpr_make_cursor(clip_->clip, memory_.data(), memory_.size(), &cursor_, nullptr),
              MCPR_OK);
  }
  std::vector<float> sample_with(mcpr_cursor* cursor, const mcpr_sample_request& request,
                                 double time) const {
    std::vector<float> out(mcpr_sample_values(clip_->clip, &request));
    EXPECT_EQ(mcpr_sample_next(cursor, &request, time, out.data(), nullptr), MCPR_OK);
    return out;
  }

  std::unique_ptr<CookedClip> clip_;
  AlignedBytes memory_;
  mcpr_cursor* cursor_ = nullptr;
};

/// Expects equal rotations and positions within the bounds.
void expect_close(const std::vector<float>& a, const std::vector<float>& b, double time) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); i += 8) {
    double apart = 0;
    for (std::size_t k = 0; k < 4; ++k)
      apart += std::pow(static_cast<double>(a[i + k]) - static_cast<double>(b[i + k]), 2);
    EXPECT_LT(2 * std::sqrt(apart), kTurnBetween) << time;
    for (std::size_t k = 4; k < 8; ++k) EXPECT_NEAR(a[i + k], b[i + k], kShiftBetween) << time;
  }
}

/// Instants of playing forwards and backwards at several rates, then random ones.
std::vector<double> instants(double first, double last, unsigned seed) {
  std::vector<double> all;
  for (const double step : {1.0, 2.0, 0.4, 3.7}) {
    for (double frame = first; frame <= last; frame += step) all.push_back(frame);
    for (double frame = last; frame >= first; frame -= step) all.push_back(frame);
  }
  Random random(seed);
  for (int i = 0; i < 60; ++i) all.push_back(first + (last - first) * random.unit());
  return all;
}

void expect_as_without(const CompressedClip& clip, const mcpr_sample_request& request = {},
                       double first = 0, double last = 0) {
  Player player(clip);
  int i = 0;
  for (const double frame : instants(first, last > 0 ? last : clip.frames - 1, 3)) {
    const std::vector<float> played = player.next(request, frame);
    expect_close(played, player.clip().sample(request, frame), frame);
    if (i++ % 7 == 0) {
      EXPECT_EQ(played, player.fresh(request, frame)) << frame;
    }
  }
}

TEST(PoseCursor, MatchesSamplingForEveryLength) {
  for (const int frames : {1, 2, 3, 4, 5, 6, 7, 8, 9, 11, 13, 16, 17, 22, 31, 33, 64, 150, 257})
    expect_as_without(clip_of_frames(frames, {.target = {Target::Kind::Error, 0.1}}));
}

TEST(PoseCursor, MatchesSamplingForEveryBasisAndEnds) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    expect_as_without(clip_of_frames(101, {.basis = basis}));
  expect_as_without(clip_of_frames(120, {.ends = Ends::Exact}));
}

TEST(PoseCursor, MatchesSamplingAcrossSegments) {
  expect_as_without(test::segmented_clip(test::smooth_motion(700),
                                         {.frames = 700, .length = 300, .overlap = 48}));
}

TEST(PoseCursor, MatchesSamplingAcrossTheSeamOfALoop) {
  for (const Loop loop : {Loop::Repeats, Loop::Follows})
    expect_as_without(clip_of_frames(90, {.loop = loop}), {.wrap = MCPR_LOOP}, -100, 300);
}

/// Uses one cursor for all levels, so that its cached frames belong to another level.
TEST(PoseCursor, LeavesOutTheSameBandsAsSampling) {
  for (const int frames : {4, 13, 31, 200}) {
    Player player(clip_of_frames(frames, {.target = {Target::Kind::Error, 0.01}}));
    Random random(9);
    for (int i = 0; i < 100; ++i) {
      const double frame = (frames - 1) * random.unit();
      const mcpr_sample_request request{
          .bands_left_out = static_cast<std::uint32_t>(random.below(MCPR_MOST_BANDS_LEFT_OUT + 1))};
      const std::vector<float> played = player.next(request, frame);
      expect_close(played, player.clip().sample(request, frame), frame);
      EXPECT_EQ(played, player.fresh(request, frame)) << frame;
    }
  }
}

TEST(PoseCursor, PathsAndListsGiveTheSameBits) {
  Player player(clip_of_frames(140));
  const std::vector<std::uint16_t> list = {5, 0, 7};
  for (double frame = 0; frame < 139; frame += 1.3) {
    const std::vector<float> all = player.fresh({.path = MCPR_PATH_PLAIN}, frame);
    for (const mcpr_path path : existing_paths())
      EXPECT_EQ(all, player.fresh({.path = path}, frame)) << frame;
    const std::vector<float> some = player.next(
        {.joints = list.data(), .joint_count = static_cast<std::uint32_t>(list.size())}, frame);
    for (std::size_t k = 0; k < list.size(); ++k)
      EXPECT_EQ(std::memcmp(&some[8 * k], &all[8 * std::size_t{list[k]}], 8 * sizeof(float)), 0);
  }
}

TEST(PoseCursor, RefusesANullCursorOrTooLittleMemory) {
  const Player player(clip_of_frames(20));
  const mcpr_cooked* const clip = player.clip().clip;
  const AlignedBytes memory(mcpr_cursor::kMostBytes);
  const std::size_t size = mcpr_cursor_bytes(clip);
  mcpr_cursor* cursor = nullptr;
  const mcpr_sample_request request{};
  float out[512];
  EXPECT_EQ(mcpr_cursor_bytes(nullptr), 0u);
  EXPECT_EQ(mcpr_make_cursor(clip, memory.data(), size - 1, &cursor, nullptr), MCPR_MEMORY);
  EXPECT_EQ(mcpr_make_cursor(clip, memory.data() + 1, size, &cursor, nullptr), MCPR_MISALIGNED);
  EXPECT_EQ(mcpr_make_cursor(nullptr, memory.data(), size, &cursor, nullptr), MCPR_ARGUMENT);
  EXPECT_EQ(mcpr_sample_next(nullptr, &request, 0, out, nullptr), MCPR_ARGUMENT);
  ASSERT_EQ(mcpr_make_cursor(clip, memory.data(), size, &cursor, nullptr), MCPR_OK);
  EXPECT_EQ(mcpr_sample_next(cursor, &request, std::nan(""), out, nullptr), MCPR_ARGUMENT);
}

/// Malicious bytes that pass the check are played without harm (run under asan).
TEST(PoseCursor, WrongNumbersAreHarmless) {
  const Player player(clip_of_frames(100, {.ends = Ends::Exact}));
  const AlignedBytes& bytes = *player.clip().bytes;
  const AlignedBytes copy(bytes.size());
  const AlignedBytes memory(mcpr_cursor::kMostBytes);
  Random random(5);
  int opened = 0;
  for (int round = 0; round < 2000; ++round) {
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    for (int k = 0; k <= round % 3; ++k) {
      const std::size_t at = 16 + random.below(round % 2 == 0 ? 160 : bytes.size() - 16);
      copy.data()[at] = static_cast<std::byte>(random.below(256));
    }
    auto* const head = reinterpret_cast<mcpr_cooked*>(copy.data());
    head->checksum = runtime::checksum_of(*head);
    const mcpr_cooked* clip = nullptr;
    if (mcpr_open_cooked(copy.data(), copy.size(), 1, &clip, nullptr) != MCPR_OK) continue;
    ++opened;
    mcpr_cursor* cursor = nullptr;
    ASSERT_EQ(mcpr_make_cursor(clip, memory.data(), memory.size(), &cursor, nullptr), MCPR_OK);
    for (const mcpr_path path : existing_paths()) {
      const mcpr_sample_request request{.path = path};
      std::vector<float> out(mcpr_sample_values(clip, &request));
      for (const double frame : {0.0, 0.5, 49.3, 48.2, 98.5, 99.0, 1e9})
        if (!out.empty()) mcpr_sample_next(cursor, &request, frame, out.data(), nullptr);
    }
  }
  EXPECT_GT(opened, 0);
}

/// Between frames a stepped joint has the transform that the cursor gives at the earlier one, to
/// the bit, on the way to the next cycle, too.
TEST(PoseCursor, SteppedJointsHaveTheBitsOfTheCursorsFrames) {
  Player player(clip_of_frames(60));
  const std::uint16_t stepped[] = {1};
  mcpr_sample_request request{.wrap = MCPR_LOOP_BLEND};
  for (int frame = 0; frame < 60; ++frame) {
    request.stepped_count = 0;
    request.stepped = nullptr;
    const std::vector<float> at_frame = player.next(request, frame);
    request.stepped = stepped;
    request.stepped_count = 1;
    const std::vector<float> held = player.next(request, frame + 0.4);
    EXPECT_EQ(std::memcmp(held.data() + 8, at_frame.data() + 8, 8 * sizeof(float)), 0) << frame;
  }
}

}  // namespace
}  // namespace mocapress
