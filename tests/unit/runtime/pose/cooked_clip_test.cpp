// SPDX-License-Identifier: MIT
// Compares cooked clips with the decoder.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "core/base/random.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/runtime/pose/cooked_check.h"
#include "tests/support/cooked_clip.h"
#include "tests/support/opened_clip.h"
#include "tests/support/segmented_clip.h"
#include "tests/support/test_motion.h"
#include "tests/support/turned_forms.h"
#include "tests/unit/runtime/paths.h"

namespace mocapress::cooked_clip_test {
namespace {

using test::CookedClip;
using test::OpenedClip;

// The bounds promised by SAMPLING.md.
constexpr double kMostTurn = 5e-4;   // radians
constexpr double kMostShift = 2e-3;  // cm

CompressedClip compressed_of(const Motion& motion, EncodeSettings options = {}) {
  options.method = Method::ClosedLoop;
  return Encoder(motion).encode(options).compressed;
}

struct Worst {
  double turn = 0;   // radians
  double shift = 0;  // cm
};

/// Compares transforms with mcpr_decode_moment.
void compare(const OpenedClip& opened, const std::vector<float>& made, mcpr_wrap wrap,
             mcpr_request decoded, double frame, Worst& worst) {
  decoded.wrap = wrap;
  std::vector<float> expected(mcpr_frame_values(opened.clip, &decoded));
  const AlignedBytes scratch(mcpr_scratch_bytes(opened.clip, &decoded));
  ASSERT_EQ(mcpr_decode_moment(opened.clip, &decoded, frame, expected.data(), scratch.data(),
                               scratch.size(), nullptr),
            MCPR_OK);
  ASSERT_EQ(made.size() / 8, expected.size() / 7);
  for (std::size_t j = 0; j < made.size() / 8; ++j) {
    double dot = 0;
    for (std::size_t k = 0; k < 4; ++k)
      dot += static_cast<double>(made[8 * j + k]) * static_cast<double>(expected[7 * j + k]);
    double apart = 0;
    for (std::size_t k = 0; k < 4; ++k)
      apart += std::pow(static_cast<double>(made[8 * j + k]) -
                            std::copysign(1.0, dot) * static_cast<double>(expected[7 * j + k]),
                        2);
    worst.turn = std::max(worst.turn, 2 * std::sqrt(apart));
    for (std::size_t k = 0; k < 3; ++k)
      worst.shift = std::max(worst.shift, std::abs(static_cast<double>(made[8 * j + 4 + k]) -
                                                   static_cast<double>(expected[7 * j + 4 + k])));
    EXPECT_EQ(made[8 * j + 7], 0);
  }
}

/// Samples frames and instants between them, the ends included.
void expect_as_decoded(const CompressedClip& clip, bool apply_ik = false,
                       std::uint32_t detail_bands = 0) {
  const OpenedClip opened(write_container(clip));
  ASSERT_NE(opened.clip, nullptr) << opened.result.message;
  const CookedClip cooked(opened.clip,
                          {.apply_ik = apply_ik ? 1 : 0, .detail_bands = detail_bands});
  ASSERT_NE(cooked.clip, nullptr) << cooked.result.message;
  const mcpr_cooked* checked = nullptr;
  mcpr_result check;
  mcpr_open_cooked(cooked.bytes->data(), cooked.bytes->size(), 1, &checked, &check);
  ASSERT_EQ(check.status, MCPR_OK) << check.message;
  const mcpr_request decoded{.output = MCPR_LOCAL, .apply_ik = apply_ik ? 1 : 0};
  const double last = clip.frames - 1;
  const AlignedBytes memory(mcpr_cursor_bytes(cooked.clip));
  mcpr_cursor* cursor = nullptr;
  ASSERT_EQ(mcpr_make_cursor(cooked.clip, memory.data(), memory.size(), &cursor, nullptr), MCPR_OK);
  const mcpr_sample_request request{};
  Worst sampled;
  Worst played;
  Random random(static_cast<std::uint64_t>(clip.frames));
  for (int i = 0; i < 300; ++i) {
    double frame = last * random.unit();
    if (i % 3 == 0) frame = std::floor(frame);
    if (apply_ik) frame = std::floor(frame);  // between frames the two interpolate differently
    if (i < 6) frame = std::min<double>(i, last);
    if (i >= 6 && i < 12) frame = std::max(last - (i - 6), 0.0);
    compare(opened, cooked.sample({}, frame), MCPR_CLAMP, decoded, frame, sampled);
    std::vector<float> next(mcpr_sample_values(cooked.clip, &request));
    ASSERT_EQ(mcpr_sample_next(cursor, &request, frame, next.data(), nullptr), MCPR_OK);
    compare(opened, next, MCPR_CLAMP, decoded, frame, played);
  }
  for (const Worst& worst : {sampled, played}) {
    EXPECT_LT(worst.turn, kMostTurn) << clip.frames;
    EXPECT_LT(worst.shift, kMostShift) << clip.frames;
  }
}

TEST(CookedClip, MatchesTheDecoder) {
  for (const int frames : {1, 2, 3, 4, 5, 7, 8, 13, 16, 31, 64, 150, 257, 512, 700})
    expect_as_decoded(
        compressed_of(test::smooth_motion(frames, static_cast<unsigned>(frames)),
                      {.target = {Target::Kind::Error, frames % 2 == 0 ? 0.05 : 0.4}}));
}

TEST(CookedClip, MatchesTheDecoderWithAnyNumberOfDetailBands) {
  for (const std::uint32_t bands : {1U, 2U, 3U, 4U, 5U})
    for (const int frames : {1, 3, 7, 16, 150}) {
      SCOPED_TRACE(bands);
      expect_as_decoded(compressed_of(test::smooth_motion(frames, static_cast<unsigned>(frames)),
                                      {.target = {Target::Kind::Error, 0.05}}),
                        false, bands);
    }
}

/// A root that swings by metres has details that weights of 16 bits are too rough for.
TEST(CookedClip, MatchesTheDecoderWhereDetailsReachFar) {
  for (const std::uint32_t bands : {2U, 4U, 5U})
    for (unsigned seed = 1; seed <= 20; ++seed) {
      SCOPED_TRACE(bands);
      expect_as_decoded(
          compressed_of(test::smooth_motion(150, seed), {.target = {Target::Kind::Error, 0.05}}),
          false, bands);
    }
}

TEST(CookedClip, TakesMoreBytesWithFewerDetailBands) {
  const OpenedClip opened(write_container(
      compressed_of(test::smooth_motion(700), {.target = {Target::Kind::Error, 0.05}})));
  std::size_t least = CookedClip(opened.clip).bytes->size();
  for (const std::uint32_t bands : {3U, 2U, 1U}) {
    const std::size_t bytes = CookedClip(opened.clip, {.detail_bands = bands}).bytes->size();
    EXPECT_GT(bytes, least) << bands;
    least = bytes;
  }
}

TEST(CookedClip, MoreDetailBandsThanThereAreIsRefused) {
  const OpenedClip opened(write_container(
      compressed_of(test::smooth_motion(20), {.target = {Target::Kind::Error, 1}})));
  const CookedClip cooked(opened.clip, {.detail_bands = MCPR_MOST_DETAIL_BANDS + 1});
  EXPECT_EQ(cooked.result.status, MCPR_ARGUMENT);
}

TEST(CookedClip, MatchesTheDecoderForEveryBasisAndEnds) {
  for (const Basis basis : {Basis::Haar, Basis::Linear, Basis::Cubic})
    expect_as_decoded(compressed_of(test::smooth_motion(200), {.basis = basis}));
  expect_as_decoded(compressed_of(test::smooth_motion(200), {.ends = Ends::Exact}));
}

TEST(CookedClip, SamplesTheVelocityThatTheLastFrameLacks) {
  CompressedClip clip = compressed_of(test::smooth_motion(200), {.ends = Ends::Exact});
  ASSERT_TRUE(clip.ends);
  clip.ends->reaches.frames[runtime::kVelocity] = 16;
  clip.ends->step_exponent[runtime::kVelocity] = 12;
  clip.ends->steps.conservativeResize(Eigen::NoChange, runtime::kMostEnds);
  clip.ends->steps.col(runtime::kVelocity).setConstant(7);
  expect_as_decoded(clip);
}

TEST(CookedClip, MatchesTheDecoderAboutTurnedAxes) {
  const Motion motion = test::smooth_motion(180);
  CompressedClip clip = test::segmented_clip(motion, SegmentLayout::whole(180));
  clip.forms = test::turned_forms(motion.skeleton);
  expect_as_decoded(clip);
}

TEST(CookedClip, SamplesAcrossSegmentBoundaries) {
  const Motion motion = test::smooth_motion(900);
  expect_as_decoded(test::segmented_clip(motion, {.frames = 900, .length = 300, .overlap = 48}));
}

TEST(CookedClip, MatchesTheDecoderWithTheIkCorrection) {
  const Motion motion = test::smooth_motion(300);
  expect_as_decoded(test::segmented_clip(motion, SegmentLayout::whole(300), true), true);
  expect_as_decoded(test::segmented_clip(motion, SegmentLayout::whole(300), true), false);
}

/// The coarse steps of other channels lose nothing to the fine ones of corrected channels.
TEST(CookedClip, MatchesTheDecoderWithTheIkCorrectionAndEnds) {
  const Motion motion = test::smooth_motion(200);
  CompressedClip clip = test::segmented_clip(motion, SegmentLayout::whole(200), true);
  clip.ends = compressed_of(motion, {.ends = Ends::Exact}).ends;
  ASSERT_TRUE(clip.ends);
  expect_as_decoded(clip, true);
}

/// The largest distance of a joint from its decoded place, at frames. cm
double largest_move(const OpenedClip& opened, const CookedClip& cooked) {
  const mcpr_clip_info info = mcpr::describe(opened.clip);
  const std::vector<float> decoded =
      opened.frames({.output = MCPR_POSITIONS, .apply_ik = 1}, 0, info.frames);
  std::vector<std::int16_t> parents;
  for (std::uint32_t j = 0; j < info.joints; ++j) {
    mcpr_joint joint{};
    EXPECT_EQ(mcpr_clip_joint(opened.clip, j, &joint, nullptr), MCPR_OK);
    parents.push_back(static_cast<std::int16_t>(joint.parent));
  }
  double largest = 0;
  for (std::uint32_t frame = 0; frame < info.frames; ++frame) {
    const std::vector<float> pose = cooked.sample({.parents = parents.data()}, frame);
    for (std::uint32_t j = 0; j < info.joints; ++j) {
      const Eigen::Map<const Eigen::Vector3f> made(&pose[8 * j + 4]);
      const Eigen::Map<const Eigen::Vector3f> place(&decoded[3 * (frame * info.joints + j)]);
      largest = std::max(largest, static_cast<double>((made - place).norm()));
    }
  }
  return largest;
}

TEST(CookedClip, AnIkErrorBoundsHowFarJointsMoveAndSavesBytes) {
  const Motion motion = test::smooth_motion(900);
  const OpenedClip opened(write_container(test::segmented_clip(motion, {900, 300, 48}, true)));
  const CookedClip exact(opened.clip, {.apply_ik = 1});
  std::size_t before = exact.bytes->size();
  for (const float error : {0.1F, 0.5F, 1.0F}) {
    const CookedClip cooked(opened.clip, {.apply_ik = 1, .ik_error = error});
    ASSERT_NE(cooked.clip, nullptr) << cooked.result.message;
    EXPECT_LT(largest_move(opened, cooked), static_cast<double>(error) + 5e-3);
    EXPECT_LT(cooked.bytes->size(), before) << error;
    before = cooked.bytes->size();
  }
  EXPECT_LT(largest_move(opened, exact), 5e-3);
  EXPECT_LT(2 * before, exact.bytes->size());
}

TEST(CookedClip, AnIkErrorBelowZeroIsRefused) {
  const OpenedClip opened(write_container(
      test::segmented_clip(test::smooth_motion(20), SegmentLayout::whole(20), true)));
  const CookedClip cooked(opened.clip, {.apply_ik = 1, .ik_error = -1});
  EXPECT_EQ(cooked.result.status, MCPR_ARGUMENT);
}

/// A joint that turns twice about one axis, one without channels, a hinge, and one that also
/// translates.
TEST(CookedClip, MatchesTheDecoderForUnusualJoints) {
  Motion motion;
  using enum ChannelKind;
  motion.skeleton.add(
      {.name = "root",
       .channels = {TranslationX, TranslationY, TranslationZ, RotationX, RotationY, RotationX}});
  motion.skeleton.add({.name = "still", .parent = 0, .offset = {1, 2, 3}, .channels = {}});
  motion.skeleton.add({.name = "hinge", .parent = 1, .offset = {0, 9, 0}, .channels = {RotationZ}});
  motion.skeleton.add({.name = "two",
                       .parent = 2,
                       .offset = {0, 5, 0},
                       .channels = {TranslationY, RotationZ, RotationX}});
  const int channels = motion.skeleton.channel_count();
  motion.clip.channels.resize(120, channels);
  for (int c = 0; c < channels; ++c)
    for (int t = 0; t < 120; ++t)
      motion.clip.channels(t, c) = (c < 3 ? 40 : 0.8) * std::sin(0.02 * (c + 1) * t + c);
  motion.clip.channels.col(4).setConstant(0.3);
  expect_as_decoded(compressed_of(motion, {.target = {Target::Kind::Error, 0.05}}));
}

/// Half angles within an eighth of a turn beside larger ones, which take another path to their
/// sines.
TEST(CookedClip, MatchesTheDecoderForSmallAndLargeAngles) {
  Motion motion;
  using enum ChannelKind;
  for (int j = 0; j < 20; ++j)
    motion.skeleton.add({.name = "j" + std::to_string(j),
                         .parent = j - 1,
                         .offset = {0, 2, 0},
                         .channels = {RotationX, RotationY, RotationZ}});
  const int channels = motion.skeleton.channel_count();
  motion.clip.channels.resize(150, channels);
  constexpr double kMost[] = {0.2, 1.5, 1.565, 1.5708, 1.6, 3, 7};
  for (int c = 0; c < channels; ++c)
    for (int t = 0; t < 150; ++t)
      motion.clip.channels(t, c) = kMost[c % 7] * std::sin(0.01 * (c % 9 + 1) * t + c);
  expect_as_decoded(test::segmented_clip(motion, SegmentLayout::whole(150)));
}

/// Roots that stay near and that go far, beside angles that hardly turn and that turn much.
TEST(CookedClip, MatchesTheDecoderWithSamplesOfAnyNumberOfBits) {
  using enum ChannelKind;
  for (const double reach : {100.0, 2500.0}) {
    Motion motion;
    for (int j = 0; j < 16; ++j)
      motion.skeleton.add(
          {.name = "j" + std::to_string(j),
           .parent = j - 1,
           .offset = {0, 2, 0},
           .channels = j == 0 ? std::vector{RotationX, RotationY, RotationZ, TranslationX}
                              : std::vector{RotationX, RotationY, RotationZ}});
    const int channels = motion.skeleton.channel_count();
    motion.clip.channels.resize(150, channels);
    for (int c = 0; c < channels; ++c)
      for (int t = 0; t < 150; ++t)
        motion.clip.channels(t, c) = (c == 3   ? reach
                                      : c < 24 ? 0.2
                                               : 1.2) *
                                     std::sin(0.01 * (c % 9 + 1) * t + c);
    expect_as_decoded(test::segmented_clip(motion, SegmentLayout::whole(150)));
  }
}

class CookedPaths : public testing::Test {
 protected:
  CookedPaths()
      : opened_(write_container(compressed_of(test::smooth_motion(333)))), cooked_(opened_.clip) {}

  OpenedClip opened_;
  CookedClip cooked_;
};

TEST_F(CookedPaths, GiveTheSameBitsWithAnyNumberOfDetailBands) {
  for (const std::uint32_t bands : {0U, 1U, 2U, 3U}) {
    const CookedClip cooked(opened_.clip, {.detail_bands = bands});
    Random random(7);
    for (int i = 0; i < 300; ++i) {
      const double frame = 332 * random.unit();
      for (const mcpr_path path : existing_paths())
        EXPECT_EQ(cooked.sample({.path = MCPR_PATH_PLAIN}, frame),
                  cooked.sample({.path = path}, frame));
    }
  }
}

TEST_F(CookedPaths, AllLayoutsAndListsAgree) {
  const std::vector<std::uint16_t> list = {5, 0, 7};
  Random random(8);
  for (int i = 0; i < 60; ++i) {
    const double frame = 332 * random.unit();
    const std::vector<float> all = cooked_.sample({}, frame);
    const std::size_t joints = all.size() / 8;
    const std::vector<float> arrays = cooked_.sample({.layout = MCPR_ARRAYS}, frame);
    const std::vector<float> matrices = cooked_.sample({.layout = MCPR_MATRICES}, frame);
    ASSERT_EQ(arrays.size(), 7 * joints);
    ASSERT_EQ(matrices.size(), 12 * joints);
    for (std::size_t j = 0; j < joints; ++j) {
      const float* const q = &all[8 * j];
      for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(arrays[k * joints + j], q[k]);
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(matrices[12 * j + 4 * k + 3], q[4 + k]);
      EXPECT_NEAR(matrices[12 * j], 1 - 2 * (q[2] * q[2] + q[3] * q[3]), 1e-6);
      EXPECT_NEAR(matrices[12 * j + 1], 2 * (q[1] * q[2] - q[0] * q[3]), 1e-6);
      EXPECT_NEAR(matrices[12 * j + 8], 2 * (q[1] * q[3] - q[0] * q[2]), 1e-6);
    }
    const std::vector<float> some = cooked_.sample(
        {.joints = list.data(), .joint_count = static_cast<std::uint32_t>(list.size())}, frame);
    ASSERT_EQ(some.size(), 8 * list.size());
    for (std::size_t k = 0; k < list.size(); ++k)
      EXPECT_EQ(std::memcmp(&some[8 * k], &all[8 * std::size_t{list[k]}], 8 * sizeof(float)), 0);
  }
}

/// A selection of a clip, with its own memory.
class Selected {
 public:
  Selected(const mcpr_cooked* clip, const std::vector<std::uint16_t>& joints)
      : memory_(mcpr_selection_bytes(clip, static_cast<std::uint32_t>(joints.size()))) {
    EXPECT_EQ(mcpr_make_selection(clip, joints.data(), static_cast<std::uint32_t>(joints.size()),
                                  memory_.data(), memory_.size(), &selection, nullptr),
              MCPR_OK);
  }
  const mcpr_selection* selection = nullptr;

 private:
  AlignedBytes memory_;
};

TEST_F(CookedPaths, SelectionsMatchLists) {
  const mcpr_cooked_info info = mcpr::describe(cooked_.clip);
  Random random(10);
  for (int i = 0; i < 100; ++i) {
    std::vector<std::uint16_t> list;
    for (std::uint32_t j = info.joints; j-- > 0;)
      if (random.unit() < 0.02 * i) list.push_back(static_cast<std::uint16_t>(j));
    if (list.empty()) list = {0};
    const Selected selected(cooked_.clip, list);
    const double frame = 332 * random.unit();
    for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS, MCPR_MATRICES})
      for (const mcpr_path path : existing_paths())
        EXPECT_EQ(cooked_.sample({.layout = layout, .path = path, .selection = selected.selection},
                                 frame),
                  cooked_.sample({.layout = layout,
                                  .path = path,
                                  .joints = list.data(),
                                  .joint_count = static_cast<std::uint32_t>(list.size())},
                                 frame));
  }
}

TEST_F(CookedPaths, GiveTheSamePosesAfterAPrefetchHint) {
  const std::vector<float> before = cooked_.sample({}, 17.3);
  mcpr_cooked_info info;
  mcpr_cooked_describe(cooked_.clip, &info);
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{1}, info.bytes, 2 * info.bytes}) {
    mcpr_prefetch_hint(cooked_.clip, bytes);
    EXPECT_EQ(cooked_.sample({}, 17.3), before) << bytes;
  }
  mcpr_prefetch_hint(nullptr, info.bytes);
}

TEST_F(CookedPaths, RefuseUnsuitableSelections) {
  const std::uint16_t joints[] = {1, 0, 1};
  const mcpr_selection* made = nullptr;
  EXPECT_EQ(mcpr_selection_bytes(nullptr, 1), 0u);
  EXPECT_EQ(mcpr_selection_bytes(cooked_.clip, 1000), 0u);
  const AlignedBytes others(sizeof(mcpr_cooked));  // without the magic number
  std::memset(others.data(), 0, sizeof(mcpr_cooked));
  const auto* const no_clip = reinterpret_cast<const mcpr_cooked*>(others.data());
  EXPECT_EQ(mcpr_selection_bytes(no_clip, 0), 0u);
  EXPECT_EQ(mcpr_cursor_bytes(no_clip), 0u);
  const std::size_t size = mcpr_selection_bytes(cooked_.clip, 3);
  const AlignedBytes memory(size);
  const auto make = [&](std::uint32_t count, std::size_t bytes) {
    return mcpr_make_selection(cooked_.clip, joints, count, memory.data(), bytes, &made, nullptr);
  };
  EXPECT_EQ(make(3, size), MCPR_ARGUMENT) << "one twice";
  EXPECT_EQ(mcpr_make_selection(no_clip, joints, 0, memory.data(), size, &made, nullptr),
            MCPR_ARGUMENT);
  EXPECT_EQ(make(2, mcpr_selection_bytes(cooked_.clip, 2) - 1), MCPR_MEMORY);
  ASSERT_EQ(make(2, size), MCPR_OK);
  const CookedClip other(opened_.clip);
  const mcpr_sample_request request{.selection = made};
  EXPECT_EQ(mcpr_sample_values(cooked_.clip, &request), 16u);
  EXPECT_EQ(mcpr_sample_values(other.clip, &request), 0u) << "of another clip";
  const mcpr_sample_request both{.joints = joints, .joint_count = 1, .selection = made};
  EXPECT_EQ(mcpr_sample_values(cooked_.clip, &both), 0u);
}

/// The error grows with the number of bands left out, and all paths agree.
TEST_F(CookedPaths, ErrorGrowsWithTheBandsLeftOut) {
  double before = 0;
  for (std::uint32_t bands = 0; bands <= MCPR_MOST_BANDS_LEFT_OUT; ++bands) {
    double apart = 0;
    for (double frame = 0.3; frame < 332; frame += 1.7) {
      const std::vector<float> all = cooked_.sample({}, frame);
      const std::vector<float> coarse = cooked_.sample({.bands_left_out = bands}, frame);
      EXPECT_EQ(coarse, cooked_.sample({.path = MCPR_PATH_PLAIN, .bands_left_out = bands}, frame));
      ASSERT_EQ(all.size(), coarse.size());
      for (std::size_t i = 0; i < all.size(); ++i)
        apart += std::pow(static_cast<double>(all[i]) - static_cast<double>(coarse[i]), 2);
    }
    EXPECT_GE(apart, before) << bands;
    before = apart;
    if (bands == 0) {
      EXPECT_EQ(apart, 0);
    }
  }
  EXPECT_GT(before, 0);
  const mcpr_sample_request request{.bands_left_out = MCPR_MOST_BANDS_LEFT_OUT + 1};
  EXPECT_EQ(mcpr_sample_values(cooked_.clip, &request), 0u);
}

TEST_F(CookedPaths, SnapToAFrameWithinRounding) {
  const std::vector<float> frame = cooked_.sample({}, 7);
  for (const double beside : {7 - 1e-5, 7 - 1e-12, 7 + 1e-12, 7 + 1e-5})
    EXPECT_EQ(cooked_.sample({}, beside), frame) << beside;
  EXPECT_NE(cooked_.sample({}, 7.001), frame);
}

TEST_F(CookedPaths, ConvertSecondsAndClampAtTheEnds) {
  const double rate = mcpr::describe(cooked_.clip).sample_rate;
  EXPECT_EQ(cooked_.sample({.unit = MCPR_SECONDS}, 100 / rate), cooked_.sample({}, 100));
  EXPECT_EQ(cooked_.sample({}, -7), cooked_.sample({}, 0));
  EXPECT_EQ(cooked_.sample({}, 1e12), cooked_.sample({}, 332));
}

TEST_F(CookedPaths, RefuseImpossibleRequests) {
  const std::vector<std::uint16_t> twice = {1, 1};
  const std::vector<std::uint16_t> beyond = {1000};
  for (const mcpr_sample_request& request :
       {mcpr_sample_request{.wrap = MCPR_LOOP},
        mcpr_sample_request{.layout = static_cast<mcpr_layout>(MCPR_WRITER + 1)},
        mcpr_sample_request{.joints = twice.data(), .joint_count = 2},
        mcpr_sample_request{.joints = beyond.data(), .joint_count = 1}})
    EXPECT_EQ(mcpr_sample_values(cooked_.clip, &request), 0u);
  float out[512];
  const mcpr_sample_request request{};
  EXPECT_EQ(mcpr_sample(cooked_.clip, &request, std::nan(""), out, nullptr), MCPR_ARGUMENT);
  for (const mcpr_wrap wrap :
       {MCPR_CLAMP, MCPR_PING_PONG, MCPR_LOOP_JUMP, MCPR_LOOP_BLEND, MCPR_LOOP_HOLD}) {
    const mcpr_sample_request seconds{.unit = MCPR_SECONDS, .wrap = wrap};
    mcpr_transform motion;
    for (const double far : {1e307, -1e307, std::numeric_limits<double>::max()}) {
      EXPECT_EQ(mcpr_sample(cooked_.clip, &seconds, far, out, nullptr), MCPR_ARGUMENT) << wrap;
      EXPECT_EQ(mcpr_sample_motion(cooked_.clip, &seconds, 0, 0, far, &motion, nullptr),
                MCPR_ARGUMENT)
          << wrap;
    }
  }
  EXPECT_EQ(mcpr_sample(nullptr, &request, 0, out, nullptr), MCPR_ARGUMENT);
}

/// Tests both kinds of loops across the seam, and in several cycles.
TEST(CookedLoop, MatchesTheDecoderAcrossTheSeam) {
  for (const Loop loop : {Loop::Repeats, Loop::Follows}) {
    const OpenedClip opened(
        write_container(compressed_of(test::smooth_motion(90), {.loop = loop})));
    ASSERT_NE(opened.clip, nullptr) << opened.result.message;
    const CookedClip cooked(opened.clip);
    ASSERT_NE(cooked.clip, nullptr) << cooked.result.message;
    Worst worst;
    for (double frame = -200; frame < 300; frame += 0.37)
      compare(opened, cooked.sample({.wrap = MCPR_LOOP}, frame), MCPR_LOOP, {.output = MCPR_LOCAL},
              frame, worst);
    for (double frame = 88; frame < 91; frame += 0.125)
      compare(opened, cooked.sample({.wrap = MCPR_LOOP}, frame), MCPR_LOOP, {.output = MCPR_LOCAL},
              frame, worst);
    EXPECT_LT(worst.turn, kMostTurn);
    EXPECT_LT(worst.shift, kMostShift);
  }
}

TEST(CookedLoop, AnyClipWrapsAsTheCallerWants) {
  for (const Loop loop : {Loop::None, Loop::Repeats, Loop::Follows}) {
    const OpenedClip opened(
        write_container(compressed_of(test::smooth_motion(90), {.loop = loop})));
    const CookedClip cooked(opened.clip);
    ASSERT_NE(cooked.clip, nullptr) << cooked.result.message;
    for (const mcpr_wrap wrap :
         {MCPR_CLAMP, MCPR_PING_PONG, MCPR_LOOP_JUMP, MCPR_LOOP_BLEND, MCPR_LOOP_HOLD}) {
      Worst worst;
      for (double frame = -200; frame < 300; frame += 0.37)
        compare(opened, cooked.sample({.wrap = wrap}, frame), wrap, {.output = MCPR_LOCAL}, frame,
                worst);
      EXPECT_LT(worst.turn, kMostTurn) << wrap;
      EXPECT_LT(worst.shift, kMostShift) << wrap;
    }
    const auto at = [&](mcpr_wrap wrap, double frame) {
      return cooked.sample({.wrap = wrap}, frame);
    };
    EXPECT_EQ(at(MCPR_PING_PONG, 89 + 3.5), at(MCPR_CLAMP, 89 - 3.5));
    EXPECT_EQ(at(MCPR_LOOP_JUMP, 89), at(MCPR_CLAMP, 0));
    EXPECT_EQ(at(MCPR_LOOP_HOLD, 89.9), at(MCPR_CLAMP, 89));
    EXPECT_EQ(at(MCPR_LOOP_HOLD, 90), at(MCPR_CLAMP, 0));
    EXPECT_NE(at(MCPR_LOOP_BLEND, 89.5), at(MCPR_CLAMP, 89));
    if (loop != Loop::Follows) continue;
    EXPECT_EQ(at(MCPR_LOOP_BLEND, 89.5), at(MCPR_LOOP, 89.5));
  }
}

/// Between the last frame and the first, an angle goes the shorter way.
TEST(CookedLoop, BlendsTheShorterWayRound) {
  Motion motion;
  motion.skeleton.add({.name = "root", .channels = {ChannelKind::TranslationX}});
  motion.skeleton.add({.name = "wheel",
                       .parent = 0,
                       .offset = {0, 5, 0},
                       .channels = {ChannelKind::RotationZ, ChannelKind::RotationX}});
  motion.skeleton.add({.name = "rim", .parent = 1, .offset = {20, 0, 0}, .channels = {}});
  motion.clip.channels.resize(64, 3);
  for (int t = 0; t < 64; ++t) motion.clip.channels.row(t) << t, 0.09 * t, 0.1 * std::sin(t);
  const OpenedClip opened(
      write_container(compressed_of(motion, {.target = {Target::Kind::Error, 0.01}})));
  const CookedClip cooked(opened.clip);
  const std::vector<float> pose = cooked.sample({.wrap = MCPR_LOOP_BLEND}, 63.5);
  ASSERT_EQ(pose.size(), 24U);
  // 63 * 0.09 radians and a whole turn are 0.61 apart.
  const double angle = 0.5 * (63 * 0.09 + 2 * 3.141592653589793);
  EXPECT_NEAR(std::abs(pose[8] * std::cos(angle / 2) + pose[11] * std::sin(angle / 2)), 1, 2e-3);
  EXPECT_NEAR(pose[4], 31.5, 0.1);
}

TEST(CookedLoop, MotionFollowsTheWrap) {
  const OpenedClip opened(write_container(compressed_of(test::smooth_motion(90))));
  const CookedClip cooked(opened.clip);
  const auto motion = [&](mcpr_wrap wrap, double from, double to) {
    mcpr_transform out;
    const mcpr_sample_request request{.wrap = wrap};
    EXPECT_EQ(mcpr_sample_motion(cooked.clip, &request, 0, from, to, &out, nullptr), MCPR_OK);
    const auto* const values = reinterpret_cast<const float*>(&out);
    return std::vector<float>(values, values + 7);
  };
  const auto expect_near = [](const std::vector<float>& made, const std::vector<float>& expected) {
    for (std::size_t i = 0; i < made.size(); ++i) EXPECT_NEAR(made[i], expected[i], 1e-4) << i;
  };
  expect_near(motion(MCPR_PING_PONG, 80, 98), motion(MCPR_CLAMP, 80, 80));
  expect_near(motion(MCPR_LOOP_JUMP, 0, 89), motion(MCPR_CLAMP, 0, 89));
  expect_near(motion(MCPR_LOOP_HOLD, 0, 90), motion(MCPR_CLAMP, 0, 89));
  expect_near(motion(MCPR_LOOP_BLEND, 0, 89.5), motion(MCPR_CLAMP, 0, 89));
  expect_near(motion(MCPR_LOOP_HOLD, 90, 120), motion(MCPR_CLAMP, 0, 30));
}

/// As in a game: the character moves by the motion on the ground, and the rest stays a pose.
TEST(CookedLoop, MotionOnTheGroundAndTheRestOfTheRootMakeTheRoot) {
  const OpenedClip opened(write_container(compressed_of(test::smooth_motion(90))));
  const CookedClip cooked(opened.clip);
  const mcpr_sample_request request{};
  const auto root_at = [&](double frame) {
    mcpr_transform root;
    std::memcpy(&root, cooked.sample(request, frame).data(), sizeof root);
    return root;
  };
  mcpr_transform start = root_at(20);
  mcpr_transform ground_at_start;
  ASSERT_EQ(mcpr_split_root(nullptr, &start, &ground_at_start, nullptr), MCPR_OK);
  mcpr_transform end = root_at(71.5);
  mcpr_transform ground_at_end;
  ASSERT_EQ(mcpr_split_root(nullptr, &end, &ground_at_end, nullptr), MCPR_OK);
  EXPECT_EQ(end.translation[0], 0);
  EXPECT_EQ(end.translation[1], root_at(71.5).translation[1]);
  EXPECT_EQ(end.translation[2], 0);
  mcpr_transform moved;
  ASSERT_EQ(mcpr_sample_ground_motion(cooked.clip, &request, 0, 20, 71.5, &moved, nullptr),
            MCPR_OK);
  EXPECT_EQ(moved.translation[1], 0);
  const auto heading = [](const mcpr_transform& turn) {
    return 2 * std::atan2(turn.rotation[2], turn.rotation[0]);
  };
  const float at_start = heading(ground_at_start);
  EXPECT_NEAR(std::remainder(at_start + heading(moved) - heading(ground_at_end), 6.2831853F), 0,
              1e-5);
  const float x = moved.translation[0];
  const float z = moved.translation[2];
  EXPECT_NEAR(ground_at_start.translation[0] + std::cos(at_start) * x + std::sin(at_start) * z,
              ground_at_end.translation[0], 1e-3);
  EXPECT_NEAR(ground_at_start.translation[2] - std::sin(at_start) * x + std::cos(at_start) * z,
              ground_at_end.translation[2], 1e-3);
  mcpr_transform back;
  const mcpr_sample_request looping{.wrap = MCPR_LOOP_JUMP};
  ASSERT_EQ(mcpr_sample_ground_motion(cooked.clip, &looping, 0, 20, 20 + 89 * 3, &moved, nullptr),
            MCPR_OK);
  ASSERT_EQ(mcpr_sample_ground_motion(cooked.clip, &looping, 0, 20 + 89 * 3, 20, &back, nullptr),
            MCPR_OK);
  EXPECT_NEAR(std::remainder(heading(moved) + heading(back), 6.2831853F), 0, 1e-5);
  EXPECT_EQ(mcpr_sample_ground_motion(cooked.clip, &request, 9999, 0, 1, &moved, nullptr),
            MCPR_ARGUMENT);
}

TEST_F(CookedPaths, SteppedJointsKeepTheEarlierFrame) {
  const std::vector<std::uint16_t> stepped = {2, 6};
  const std::vector<std::uint16_t> list = {6, 1, 2};
  for (const mcpr_layout layout : {MCPR_TRANSFORMS, MCPR_ARRAYS, MCPR_MATRICES})
    for (const bool all : {true, false}) {
      mcpr_sample_request request{.layout = layout};
      if (!all) request.joints = list.data(), request.joint_count = 3;
      const std::vector<float> between = cooked_.sample(request, 100.25);
      const std::vector<float> frame = cooked_.sample(request, 100);
      request.stepped = stepped.data();
      request.stepped_count = 2;
      const std::vector<float> held = cooked_.sample(request, 100.25);
      ASSERT_EQ(held.size(), between.size());
      const std::size_t joints = all ? mcpr::describe(cooked_.clip).joints : 3;
      const std::size_t values = held.size() / joints;
      for (std::size_t i = 0; i < held.size(); ++i) {
        const std::size_t joint = layout == MCPR_ARRAYS ? i % joints : i / values;
        const bool is_stepped = all ? joint == 2 || joint == 6 : joint != 1;
        EXPECT_EQ(held[i], is_stepped ? frame[i] : between[i]) << i;
      }
      EXPECT_EQ(cooked_.sample(request, 100), frame);
    }
  const std::vector<std::uint16_t> beyond = {1000};
  EXPECT_TRUE(cooked_.sample({.stepped = beyond.data(), .stepped_count = 1}, 1).empty());
  EXPECT_TRUE(cooked_.sample({.stepped_count = 1}, 1).empty());
}

TEST(CookedLoop, MotionAccumulatesOverCycles) {
  const OpenedClip opened(
      write_container(compressed_of(test::smooth_motion(90), {.loop = Loop::Repeats})));
  const CookedClip cooked(opened.clip);
  const mcpr_sample_request request{.wrap = MCPR_LOOP};
  const auto motion = [&](double from, double to) {
    mcpr_transform out;
    EXPECT_EQ(mcpr_sample_motion(cooked.clip, &request, 0, from, to, &out, nullptr), MCPR_OK);
    return out;
  };
  const auto length = [](const mcpr_transform& by) {
    return std::hypot(by.translation[0], by.translation[1], by.translation[2]);
  };
  EXPECT_NEAR(length(motion(10, 10)), 0, 1e-3);
  // A cycle's motion, in the root's local space, does not depend on where it starts.
  EXPECT_NEAR(length(motion(0, 89)), length(motion(89, 178)), 2e-2);
  EXPECT_NEAR(length(motion(0, 89)), length(motion(89, 0)), 2e-2);
  EXPECT_NEAR(motion(5, 300).rotation[0], motion(94, 389).rotation[0], 1e-3);
}

class HostileCooked : public testing::Test {
 protected:
  HostileCooked()
      : opened_(write_container(compressed_of(test::smooth_motion(100), {.ends = Ends::Exact}))),
        cooked_(opened_.clip) {}

  static mcpr_status open(const AlignedBytes& bytes, std::size_t size, const mcpr_cooked** clip) {
    return mcpr_open_cooked(bytes.data(), size, 1, clip, nullptr);
  }

  OpenedClip opened_;
  CookedClip cooked_;
};

TEST_F(HostileCooked, EveryTruncationIsRefused) {
  const std::size_t whole = cooked_.bytes->size();
  const mcpr_cooked* clip = nullptr;
  for (std::size_t size = 0; size < whole; ++size) {
    const AlignedBytes cut(std::max<std::size_t>(size, 1));
    std::memcpy(cut.data(), cooked_.bytes->data(), size);
    EXPECT_NE(open(cut, size, &clip), MCPR_OK) << size;
  }
}

TEST_F(HostileCooked, EveryFlippedBitIsRefused) {
  const AlignedBytes copy(cooked_.bytes->size());
  std::memcpy(copy.data(), cooked_.bytes->data(), copy.size());
  const mcpr_cooked* clip = nullptr;
  ASSERT_EQ(open(copy, copy.size(), &clip), MCPR_OK);
  for (std::size_t i = 0; i < copy.size(); ++i) {
    const std::byte flip{static_cast<unsigned char>(1U << (i % 8))};
    copy.data()[i] ^= flip;
    EXPECT_NE(open(copy, copy.size(), &clip), MCPR_OK) << i;
    copy.data()[i] ^= flip;
  }
}

/// Malicious bytes with a valid checksum are refused or sampled without harm (run under asan).
TEST_F(HostileCooked, WrongNumbersWithTheRightChecksumAreRefusedOrHarmless) {
  const std::size_t size = cooked_.bytes->size();
  const AlignedBytes copy(size);
  Random random(3);
  int opened = 0;
  for (int round = 0; round < 4000; ++round) {
    std::memcpy(copy.data(), cooked_.bytes->data(), size);
    for (int k = 0; k <= round % 3; ++k) {
      // Even rounds change the head and the first tables, odd ones anything.
      const std::size_t at = 16 + random.below(round % 2 == 0 ? 140 : size - 16);
      copy.data()[at] = static_cast<std::byte>(random.below(256));
    }
    auto* const head = reinterpret_cast<mcpr_cooked*>(copy.data());
    head->checksum = runtime::checksum_of(*head);
    const mcpr_cooked* clip = nullptr;
    if (open(copy, size, &clip) != MCPR_OK) continue;
    ++opened;
    for (const mcpr_wrap wrap : {MCPR_CLAMP, MCPR_LOOP})
      for (const mcpr_path path : existing_paths()) {
        const mcpr_sample_request request{.wrap = wrap, .path = path};
        std::vector<float> out(mcpr_sample_values(clip, &request));
        for (const double frame : {0.0, 0.5, 49.3, 98.5, 99.0, 1e9})
          if (!out.empty()) mcpr_sample(clip, &request, frame, out.data(), nullptr);
      }
  }
  EXPECT_GT(opened, 0);
}

}  // namespace
}  // namespace mocapress::cooked_clip_test
