// SPDX-License-Identifier: MIT
// The promises of every comparison method.
#include "core/codec/methods/comparison_method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/codec/format/deflate.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress::comparison_method_test {
namespace {

using Bytes = std::vector<std::byte>;

/// A chain of joints with six channels each, rotations first.
Skeleton six_channel_skeleton() {
  using enum ChannelKind;
  Skeleton skeleton;
  for (int j = 0; j < 4; ++j)
    skeleton.add(
        {.name = "joint" + std::to_string(j),
         .parent = j - 1,
         .offset = {0, 15.0, 2.0 * j},
         .channels = {RotationY, RotationZ, RotationX, TranslationX, TranslationY, TranslationZ}});
  return skeleton;
}

Motion six_channel_motion(int frames) {
  Motion motion{six_channel_skeleton(), {}};
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (int c = 0; c < motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < frames; ++t)
      motion.clip.channels(t, c) =
          (is_rotation(motion.skeleton.channel_kind(c)) ? 0.6 : 4) * std::sin(0.05 * t + c);
  return motion;
}

Motion still_motion(int frames) {
  Motion motion = test::smooth_motion(frames);
  motion.clip.channels.rowwise() = Eigen::RowVectorXd(motion.clip.channels.row(0));
  return motion;
}

class EveryComparisonMethod : public testing::TestWithParam<const ComparisonMethod*> {
 protected:
  const ComparisonMethod& method() const { return *GetParam(); }

  std::unique_ptr<DetailCoder> analyse(const Motion& motion) const {
    return method().analyse(motion, Weighting::BoneEnds);
  }
  Clip decode(const Motion& motion, const Bytes& bytes) const {
    return method().decode(motion.skeleton, motion.clip.sample_rate_hz, motion.clip.frames(),
                           bytes);
  }
  double eps(const Motion& motion, const Bytes& bytes) const {
    return measure(motion.skeleton, motion.clip, decode(motion, bytes)).eps_bone_ends;
  }
  /// Expects the bytes to be decoded, or refused by a FormatError.
  void expect_survived(const Motion& motion, const Bytes& bytes) const {
    try {
      const Clip clip = decode(motion, bytes);
      EXPECT_EQ(clip.channels.rows(), motion.clip.channels.rows());
      EXPECT_EQ(clip.channels.cols(), motion.clip.channels.cols());
    } catch (const FormatError&) {
    }
  }
};

/// Details that differ by a factor of about 1.6, from none to the most.
std::vector<int> ladder(const DetailCoder& coder) {
  std::vector<int> details{0};
  for (double d = 1; d < coder.most_detail(); d *= 1.6) details.push_back(static_cast<int>(d));
  details.push_back(coder.most_detail());
  return details;
}

TEST_P(EveryComparisonMethod, RoundTripsWithMostDetail) {
  for (const Motion& motion : {test::smooth_motion(150), six_channel_motion(90)}) {
    const auto coder = analyse(motion);
    EXPECT_LT(eps(motion, coder->encode(coder->most_detail())), 0.1);  // cm
  }
}

TEST_P(EveryComparisonMethod, MoreDetailTakesMoreBytesAndErrsLess) {
  const Motion motion = test::smooth_motion(150);
  const auto coder = analyse(motion);
  std::vector<double> errors;
  std::vector<std::size_t> sizes;
  for (const int detail : ladder(*coder)) {
    const Bytes bytes = coder->encode(detail);
    errors.push_back(eps(motion, bytes));
    sizes.push_back(bytes.size());
  }
  // DEFLATE and non-linear poses allow small steps back.
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_LT(errors[i], 1.15 * errors[i - 1] + 0.02) << i;
    EXPECT_GT(static_cast<double>(sizes[i]), 0.95 * static_cast<double>(sizes[i - 1]) - 8) << i;
  }
  EXPECT_LT(errors.back(), 0.05 * errors.front());
  EXPECT_GT(sizes.back(), 2 * sizes.front());
}

TEST_P(EveryComparisonMethod, SameMotionSameBytes) {
  const Motion motion = test::smooth_motion(100);
  const auto coder = analyse(motion);
  const int detail = coder->most_detail() / 3;
  EXPECT_EQ(coder->encode(detail), analyse(motion)->encode(detail));
}

TEST_P(EveryComparisonMethod, StillAndShortClipsComeBack) {
  for (const int frames : {1, 2, 3, 4, 5, 7, 9, 33})
    for (const Motion& motion : {still_motion(frames), test::smooth_motion(frames)}) {
      const auto coder = analyse(motion);
      for (const int detail : {0, coder->most_detail() / 2, coder->most_detail()})
        EXPECT_TRUE(decode(motion, coder->encode(detail)).channels.allFinite());
      EXPECT_LT(eps(motion, coder->encode(coder->most_detail())), 0.1) << frames << " frames";
    }
}

TEST_P(EveryComparisonMethod, AClipWithoutFramesOrChannelsComesBack) {
  const Motion no_frames = test::smooth_motion(0);
  EXPECT_EQ(decode(no_frames, analyse(no_frames)->encode(0)).channels.rows(), 0);
  Motion no_channels;
  no_channels.skeleton.add({.name = "root"});
  no_channels.clip.channels.resize(12, 0);
  EXPECT_EQ(decode(no_channels, analyse(no_channels)->encode(0)).channels.rows(), 12);
}

TEST_P(EveryComparisonMethod, RefusesEveryTruncation) {
  const Motion motion = test::smooth_motion(20);
  const auto coder = analyse(motion);
  const Bytes whole = coder->encode(std::min(coder->most_detail(), 5));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<long>(size));
    EXPECT_THROW(decode(motion, part), FormatError) << size << " of " << whole.size();
  }
}

TEST_P(EveryComparisonMethod, RefusesEveryTruncationOfWhatIsDeflated) {
  const Motion motion = test::smooth_motion(8);
  const auto coder = analyse(motion);
  const Bytes whole = inflate_bytes(coder->encode(std::min(coder->most_detail(), 5)), 1 << 20);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<long>(size));
    EXPECT_THROW(decode(motion, deflate_bytes(part)), FormatError)
        << size << " of " << whole.size();
  }
  Bytes longer = whole;
  longer.push_back(std::byte{0});
  EXPECT_THROW(decode(motion, deflate_bytes(longer)), FormatError);
}

TEST_P(EveryComparisonMethod, SurvivesRandomDamage) {
  const Motion motion = test::smooth_motion(30);
  const auto coder = analyse(motion);
  const Bytes whole = coder->encode(std::min(coder->most_detail(), 20));
  const Bytes inflated = inflate_bytes(whole, 1 << 20);
  Random random(3);
  for (int trial = 0; trial < 150; ++trial) {
    Bytes inside = inflated;
    Bytes outside = whole;
    for (int flips = 0; flips <= trial % 4; ++flips) {
      // Every other flip is within the head, which holds counts.
      const std::size_t most =
          flips % 2 == 0 ? std::min<std::size_t>(40, inside.size()) : inside.size();
      inside[random.below(most)] = static_cast<std::byte>(random.below(256));
      outside[random.below(outside.size())] = static_cast<std::byte>(random.below(256));
    }
    expect_survived(motion, deflate_bytes(inside));
    expect_survived(motion, outside);
  }
}

TEST_P(EveryComparisonMethod, RefusesRandomBytes) {
  const Motion motion = test::smooth_motion(30);
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    Bytes noise(random.below(200));
    for (std::byte& byte : noise) byte = static_cast<std::byte>(random.below(256));
    expect_survived(motion, noise);
    expect_survived(motion, deflate_bytes(noise));
  }
}

TEST_P(EveryComparisonMethod, InflatesNoMoreThanSomeTimesItsClip) {
  const Motion motion = test::smooth_motion(50);
  const auto raw = static_cast<std::size_t>(4 * motion.clip.channels.size());
  try {
    decode(motion, deflate_bytes(Bytes(16 * raw)));
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find("inflates to more bytes than allowed"),
              std::string::npos)
        << error.what();
  }
}

TEST_P(EveryComparisonMethod, HasANameATitleAndANote) {
  EXPECT_EQ(find_comparison_method(method().name), &method());
  EXPECT_FALSE(method().title.empty());
  EXPECT_GT(method().note.size(), 20u);
}

INSTANTIATE_TEST_SUITE_P(, EveryComparisonMethod,
                         testing::ValuesIn(comparison_methods().begin(),
                                           comparison_methods().end()),
                         [](const auto& of) {
                           std::string name(of.param->name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(ComparisonMethods, FindNoneByAnotherName) {
  EXPECT_EQ(find_comparison_method("standard"), nullptr);
  EXPECT_EQ(find_comparison_method(""), nullptr);
}

}  // namespace
}  // namespace mocapress::comparison_method_test
