// SPDX-License-Identifier: MIT
#include "core/codec/encode/mend/end_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/motion/loop.h"
#include "tests/support/loop_of.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

constexpr double kEndTarget = 0.5;  // cm

EncodeSettings with_ends(Ends ends, Weighting weighting = Weighting::Surface) {
  return {.method = Method::ClosedLoop,
          .weighting = weighting,
          .target = {Target::Kind::Error, kEndTarget},
          .ends = ends};
}

/// RMS in the weighting of the first and the last pose, as decode() has them. cm
std::pair<double, double> errors_at_ends(const Motion& motion, const CompressedClip& compressed,
                                         Weighting weighting) {
  const PointErrors errors(motion.skeleton, weighting);
  const Eigen::VectorXd squares = errors.squared(body_tracks(motion.skeleton, motion.clip),
                                                 body_tracks(motion.skeleton, decode(compressed))) *
                                  errors.measured().weights;
  return {std::sqrt(squares(0)), std::sqrt(squares(squares.size() - 1))};
}

TEST(EndFit, EvenEndsAreNoFurtherOffThanTheTargetInClipsOfAnyLength) {
  for (const int frames : {1, 2, 3, 5, 17, 64, 301}) {
    const Motion motion = test::smooth_motion(frames, 7);
    const Encoding encoding = Encoder(motion).encode(with_ends(Ends::Even));
    const auto [first, last] = errors_at_ends(motion, encoding.compressed, Weighting::Surface);
    EXPECT_LE(first, kEndTarget) << frames;
    EXPECT_LE(last, kEndTarget) << frames;
  }
}

/// A chain of joints, each of which turns to and fro by up to a degree.
Motion waving_chain(int joints, int frames) {
  Motion motion;
  for (int j = 0; j < joints; ++j)
    motion.skeleton.add(
        {.name = "joint_" + std::to_string(j),
         .parent = j - 1,
         .offset = Eigen::Vector3d(0, 0.5, 0),
         .channels = {ChannelKind::RotationX, ChannelKind::RotationY, ChannelKind::RotationZ}});
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  for (Eigen::Index c = 0; c < motion.clip.channels.cols(); ++c)
    for (Eigen::Index t = 0; t < frames; ++t)
      motion.clip.channels(t, c) = 0.02 * std::sin(0.7 * static_cast<double>(c + t * (1 + c % 3)));
  return motion;
}

TEST(EndFit, HoldsEndsOfTooManyChannelsToBeWeighedAgainstEachOther) {
  const Motion motion = waving_chain(400, 9);
  for (const Ends ends : {Ends::Even, Ends::Exact}) {
    EncodeSettings options = with_ends(ends);
    options.loop = Loop::None;
    const Encoding encoding = Encoder(motion).encode(options);
    const auto [first, last] = errors_at_ends(motion, encoding.compressed, Weighting::Surface);
    EXPECT_LE(first, kEndTarget * (ends == Ends::Exact ? 0.1 : 1));
    EXPECT_LE(last, kEndTarget * (ends == Ends::Exact ? 0.1 : 1));
  }
}

TEST(EndFit, AnEvenEndIsNotMendedByAllChannels) {
  Eigen::Index mended = 0;
  Eigen::Index channels = 0;
  for (unsigned seed = 1; seed <= 16; ++seed) {  // one clip more, another less
    const Motion motion = test::smooth_motion(150, seed);
    const CompressedClip compressed = Encoder(motion).encode(with_ends(Ends::Even)).compressed;
    ASSERT_TRUE(compressed.ends);
    mended += (compressed.ends->steps.array() != 0).count();
    channels += 2 * motion.clip.channels.cols();  // at both ends
  }
  EXPECT_GT(mended, 0);
  EXPECT_LE(4 * mended, 3 * channels);
}

TEST(EndFit, ExactEndsAreWithinATenthOfTheTargetInEveryWeighting) {
  const Motion motion = test::smooth_motion(200, 2);
  for (const Weighting weighting : kWeightingsWithoutMesh) {
    const Encoding encoding = Encoder(motion).encode(with_ends(Ends::Exact, weighting));
    const auto [first, last] = errors_at_ends(motion, encoding.compressed, weighting);
    EXPECT_LE(first, 0.1 * kEndTarget) << name(weighting);
    EXPECT_LE(last, 0.1 * kEndTarget) << name(weighting);
  }
}

TEST(EndFit, ExactEndsHoldBesideACorrectionAndInSegments) {
  const Motion motion = test::smooth_motion(700, 3);
  EncodeSettings corrected = with_ends(Ends::Exact);
  corrected.correction = EncodeCorrection{
      .joints = {motion.skeleton.joint_count() - 1, motion.skeleton.joint_count() - 4},
      .ratio = 8.0};
  EncodeSettings in_segments = with_ends(Ends::Exact);
  in_segments.segments.longest = 256;
  for (const EncodeSettings& asked : {corrected, in_segments}) {
    const Encoding encoding = Encoder(motion).encode(asked);
    const auto [first, last] = errors_at_ends(motion, encoding.compressed, Weighting::Surface);
    EXPECT_LE(first, 0.1 * kEndTarget);
    EXPECT_LE(last, 0.1 * kEndTarget);
  }
}

TEST(EndFit, NothingJumpsFromALoopsLastFrameToItsFirst) {
  const Motion loop = test::loop_of(test::smooth_motion(600, 6), 1);
  ASSERT_GT(loop.clip.frames(), 100);
  EncodeSettings asked = with_ends(Ends::Even);
  for (const Target target :
       {Target{Target::Kind::Error, kEndTarget}, {Target::Kind::MaxError, 3}}) {
    asked.target = target;
    asked.loop = Loop::Repeats;
    const EndErrors told = Encoder(loop).encode(asked).distortion.ends;
    EXPECT_LE(told.seam_cm, told.worst_neighbours_cm);
    EXPECT_LE(told.seam_cm, 0.2 * target.value);
    asked.loop = Loop::None;
    EXPECT_LT(told.seam_cm, Encoder(loop).encode(asked).distortion.ends.seam_cm);
  }
}

/// The chain's ends are alike enough for a loop, and yet the same error in angles is a much larger
/// one in the last pose.
TEST(EndFit, BothEndsOfALoopKeepThePromiseThoughTheirPosesDiffer) {
  for (const auto& [joints, frames] : {std::pair{400, 9}, {100, 17}, {400, 18}}) {
    const Motion motion = waving_chain(joints, frames);
    ASSERT_NE(find_loop(motion), Loop::None);
    for (const Ends ends : {Ends::Even, Ends::Exact}) {
      const Encoding encoding = Encoder(motion).encode(with_ends(ends));
      const auto [first, last] = errors_at_ends(motion, encoding.compressed, Weighting::Surface);
      const double promise = kEndTarget * (ends == Ends::Exact ? 0.1 : 1);
      EXPECT_LE(first, promise) << joints << " joints, " << frames << " frames, " << name(ends);
      EXPECT_LE(last, promise) << joints << " joints, " << frames << " frames, " << name(ends);
    }
  }
}

TEST(EndFit, VelocitiesOfALoopBreakNoMoreAtItsSeamThanElsewhere) {
  int mended = 0;
  for (int seed = 1; seed <= 8; ++seed) {
    const Motion loop = test::loop_of(test::smooth_motion(300, static_cast<unsigned>(seed)), 0.5);
    EncodeSettings asked = with_ends(Ends::Even);
    asked.loop = Loop::Repeats;
    const Encoding encoding = Encoder(loop).encode(asked);
    const EndErrors& ends = encoding.distortion.ends;
    EXPECT_LE(ends.seam_cm_per_frame, ends.worst_neighbours_cm_per_frame) << seed;
    EXPECT_LE(ends.seam_cm, 0.25 * kEndTarget) << seed;
    EXPECT_LE(encoding.distortion.surface.rms, kEndTarget) << seed;
    const std::optional<CodedEnds>& coded = encoding.compressed.ends;
    mended += coded && coded->count() > runtime::kVelocity;
  }
  EXPECT_GT(mended, 0);
}

TEST(EndFit, ExactEndsKeepATenthOfAHardMaximum) {
  const Motion motion = test::smooth_motion(150, 4);
  EncodeSettings asked = with_ends(Ends::Exact);
  asked.target = {Target::Kind::MaxError, 3};
  const Encoding encoding = Encoder(motion).encode(asked);
  const PointErrors errors(motion.skeleton, Weighting::Surface);
  const Eigen::MatrixXd squared =
      errors.squared(body_tracks(motion.skeleton, motion.clip),
                     body_tracks(motion.skeleton, decode(encoding.compressed)));
  EXPECT_LE(squared.maxCoeff(), 3.0 * 3.0);
  EXPECT_LE(squared.row(0).maxCoeff(), 0.3 * 0.3);
  EXPECT_LE(squared.bottomRows(1).maxCoeff(), 0.3 * 0.3);
}

TEST(EndFit, NothingIsCodedWhereItIsNotAskedFor) {
  const Motion motion = test::smooth_motion(100);
  EXPECT_FALSE(Encoder(motion).encode(with_ends(Ends::Free)).compressed.ends);
  EncodeSettings bounded = with_ends(Ends::Even);
  bounded.target = {Target::Kind::MaxError, 3};
  EXPECT_FALSE(Encoder(motion).encode(bounded).compressed.ends);
}

TEST(EndFit, TheRuntimeDecoderGivesTheSameBits) {
  const Motion motion = test::smooth_motion(700, 5);
  EncodeSettings in_segments = with_ends(Ends::Exact);
  in_segments.segments.longest = 256;
  for (const EncodeSettings& asked : {with_ends(Ends::Exact), in_segments}) {
    CompressedClip compressed = Encoder(motion).encode(asked).compressed;
    ASSERT_TRUE(compressed.ends);
    CodedEnds& ends = *compressed.ends;
    ends.reaches.frames[runtime::kVelocity] = 20;
    ends.step_exponent[runtime::kVelocity] = 9;
    ends.steps.conservativeResize(Eigen::NoChange, runtime::kMostEnds);
    ends.steps.col(runtime::kVelocity).setConstant(-3);
    const test::OpenedClip opened(write_container(compressed));
    ASSERT_NE(opened.clip, nullptr) << opened.result.message;
    EXPECT_EQ(opened.info.motion_bytes, compressed.motion_bytes());
    const std::vector<float> rows = opened.frames({}, 0, 700);
    const Eigen::MatrixXf expected =
        decode_uncorrected(compressed).clip.channels.cast<float>().transpose();
    ASSERT_EQ(std::ssize(rows), expected.size());
    EXPECT_EQ(Eigen::Map<const Eigen::MatrixXf>(rows.data(), expected.rows(), 700), expected);
    for (const int frame : {0, 1, 698, 699}) {
      const std::vector<float> row = opened.moment({}, frame);
      EXPECT_EQ(Eigen::Map<const Eigen::VectorXf>(row.data(), std::ssize(row)),
                expected.col(frame));
    }
  }
}

TEST(EndFit, EveryPrefixOfAFileWithEndsIsRefused) {
  const std::vector<std::byte> file =
      write_container(Encoder(test::smooth_motion(40)).encode(with_ends(Ends::Exact)).compressed);
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_EQ(test::OpenedClip(std::span(file).first(size)).clip, nullptr) << size;
}

}  // namespace
}  // namespace mocapress
