// SPDX-License-Identifier: MIT
#include "core/codec/encode/mend/correction_encoder.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/metrics/rate.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/test_motion.h"

namespace mocapress::correction_encoder_test {
namespace {

const Encoder& walk() {
  static const Encoder shared(samples::walk_clip());
  return shared;
}

EncodeSettings with_correction(Target target, EncodeCorrection correction) {
  return {.method = Method::Standard,
          .weighting = Weighting::BoneEnds,
          .target = target,
          .correction = correction};
}

constexpr Target kThirty = {Target::Kind::CoefficientRatio, 30};

TEST(CorrectionEncoder, HoldsTheFeetForTheSameSize) {
  for (const CorrectAt at : {CorrectAt::EveryFrame, CorrectAt::Contacts})
    for (const IkSolver solver : {IkSolver::CyclicDescent, IkSolver::NearestPose}) {
      const Encoding with =
          walk().encode(with_correction(kThirty, {.ratio = 16.0, .solver = solver, .at = at}));
      const auto bytes = static_cast<double>(with.compressed.motion_bytes());
      const Encoding without = walk().encode({.method = Method::Standard,
                                              .weighting = Weighting::BoneEnds,
                                              .target = {Target::Kind::Size, bytes}});
      EXPECT_LT(with.footskate.total_cm, 0.2 * without.footskate.total_cm) << name(at);
    }
}

TEST(CorrectionEncoder, CountsInARatio) {
  const Encoding encoding =
      walk().encode(with_correction({Target::Kind::Ratio, 30}, {.ratio = 8.0}));
  EXPECT_GT(encoding.compressed.correction_bytes(), 100u);
  EXPECT_NEAR(compression_ratio(walk().motion().clip, encoding.compressed.motion_bytes()) / 30, 1,
              0.02);
  EXPECT_EQ(encoding.correction->ratio, 8);
}

TEST(CorrectionEncoder, CombinesWithTheClosedLoopInOneStream) {
  const Target target = {Target::Kind::Ratio, 200};
  const auto closed = [&](std::optional<EncodeCorrection> correction) {
    return walk().encode({.method = Method::ClosedLoop,
                          .weighting = Weighting::BoneEnds,
                          .target = target,
                          .correction = std::move(correction)});
  };
  const Encoding with = closed(EncodeCorrection{.ratio = 16.0});
  EXPECT_NEAR(compression_ratio(walk().motion().clip, with.compressed.motion_bytes()) / 200, 1,
              0.02);
  EXPECT_GT(with.compressed.correction_bytes(), 50u);
  EXPECT_LT(with.compressed.correction_bytes(), with.compressed.motion_bytes() / 2);
  EXPECT_LT(with.footskate.total_cm, 0.5 * closed({}).footskate.total_cm);
  EXPECT_EQ(decode(with.compressed).channels, with.decoded.channels);
  const CompressedClip again = read_container(write_container(with.compressed));
  EXPECT_EQ(decode_uncorrected(again).clip.channels, with.correction->uncorrected.channels);
}

TEST(CorrectionEncoder, FindsASplitThatHoldsTheFeetAndSparesTheRest) {
  const Target target = {Target::Kind::Ratio, 40};
  const Encoding without = walk().encode(
      {.method = Method::Standard, .weighting = Weighting::BoneEnds, .target = target});
  const Encoding with = walk().encode(with_correction(target, {}));
  EXPECT_LT(with.footskate.total_cm, 0.5 * without.footskate.total_cm);
  EXPECT_LE(with.distortion.eps_bone_ends, 1.2 * without.distortion.eps_bone_ends);
}

TEST(CorrectionEncoder, TakesOtherJointsThanTheFeetAndMoreThanTwo) {
  const Skeleton& skeleton = walk().motion().skeleton;
  EncodeCorrection options{.ratio = 4.0};
  for (const char* joint : {"ltoes", "rtoes", "lhand", "rhand"})
    options.joints.push_back(skeleton.find(joint));
  const Encoding encoding = walk().encode(with_correction(kThirty, options));
  const CompressedClip read = read_container(write_container(encoding.compressed));
  ASSERT_EQ(read.correction->effectors.size(), 4u);
  for (std::size_t e = 0; e < 4; ++e) {
    EXPECT_EQ(read.correction->effectors[e].joint, options.joints[e]);
    EXPECT_EQ(read.correction->effectors[e].chain,
              encoding.compressed.correction->effectors[e].chain);
  }
  const auto hand = static_cast<Eigen::Index>(options.joints[2]);
  const auto worst = [&](const Clip& clip) {
    return (landmark_tracks(skeleton, clip) - walk().original_tracks())
        .middleCols<3>(3 * hand)
        .rowwise()
        .norm()
        .maxCoeff();
  };
  EXPECT_LT(worst(encoding.decoded), 0.5 * worst(encoding.correction->uncorrected));
}

TEST(CorrectionEncoder, KeepsTheKneesFromSnapping) {
  const Encoding encoding = walk().encode(with_correction(kThirty, {.ratio = 16.0}));
  EXPECT_LE(encoding.correction->fastest_knee, 1.2 * encoding.correction->fastest_knee_of_original);
}

TEST(CorrectionEncoder, HeedsEditedContacts) {
  EncodeSettings options = with_correction(kThirty, {.ratio = 16.0, .at = CorrectAt::Contacts});
  options.contacts.emplace();  // the user took them all away
  const Encoding encoding = walk().encode(options);
  EXPECT_EQ(encoding.decoded.channels, encoding.correction->uncorrected.channels);
}

TEST(CorrectionEncoder, DecodesTheSameFromAFile) {
  const Encoding encoding = walk().encode(with_correction(kThirty, {.ratio = 16.0}));
  const Clip read = decode(read_container(write_container(encoding.compressed)));
  EXPECT_LT((read.channels - encoding.decoded.channels).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(CorrectionEncoder, SaysThatASkeletonHasNoFeet) {
  Motion pole;
  pole.skeleton.add({.name = "pole", .channels = {ChannelKind::RotationX}});
  pole.clip.channels.setZero(10, 1);
  EXPECT_THROW(Encoder(pole).encode(with_correction(kThirty, {})), Error);
}

}  // namespace
}  // namespace mocapress::correction_encoder_test
