// SPDX-License-Identifier: MIT
#include "core/codec/encode/analysis/form_choice.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/codec/decode/decoder.h"
#include "core/codec/decode/runtime_clip.h"
#include "core/codec/encode/analysis/clip_analysis.h"
#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress::form_choice_test {
namespace {

using enum ChannelKind;

/// Somebody who rolls about: smooth in the order y x z. In z y x the middle angle is near a right
/// one throughout, so that the outer two change wildly.
Motion near_the_pole(int frames = 300) {
  Motion smooth;
  smooth.skeleton.add({.name = "root",
                       .channels = {RotationY, RotationX, RotationZ},
                       .end_site = Eigen::Vector3d(10, 40, 15)});
  smooth.clip.channels.resize(frames, 3);
  for (int t = 0; t < frames; ++t)
    smooth.clip.channels.row(t) =
        Eigen::RowVector3d(1.57 + 0.2 * std::cos(0.065 * t), 0.03 * std::sin(0.05 * t),
                           0.15 + 0.03 * std::sin(0.035 * t));
  return with_forms(smooth, RotationForms{{RotationOrder::Zyx}});
}

EncodeSettings closed_loop(double eps_cm = 0.2) {
  return {.method = Method::ClosedLoop,
          .coding = Coding::Adaptive,
          .weighting = Weighting::BoneEnds,
          .target = {Target::Kind::Error, eps_cm}};
}

TEST(FormChoice, LeavesAnOrderWhoseMiddleAngleIsNearARightOne) {
  const ClipAnalysis source(near_the_pole());
  const ClipAnalysis& chosen = source.in_chosen_forms();
  EXPECT_NE(rotation_forms(chosen.motion().skeleton), rotation_forms(source.motion().skeleton));
  const auto coefficients = [](const ClipAnalysis& analysis) {
    return (analysis.closed_loop(Basis::Cubic, Weighting::BoneEnds)
                .quantise(0.5)
                .coded.values.array() != 0)
        .count();
  };
  EXPECT_LT(coefficients(chosen), 0.8 * static_cast<double>(coefficients(source)));
}

TEST(FormChoice, KeepsTheOrdersOfWhatDoesNotMove) {
  Motion still = near_the_pole(1);
  still.clip.channels = still.clip.channels.replicate(100, 1).eval();
  EXPECT_EQ(choose_forms(still), rotation_forms(still.skeleton));
  still.clip.channels.resize(0, 3);
  EXPECT_EQ(choose_forms(still), rotation_forms(still.skeleton));
}

TEST(FormChoice, IsTheSameEachTime) {
  const Motion motion = test::smooth_motion(500);
  EXPECT_EQ(choose_forms(motion), choose_forms(motion));
}

TEST(FormChoice, FilesGiveTheChannelsOfTheSourceBack) {
  const Motion motion = near_the_pole();
  const Encoding encoding = Encoder(motion).encode(closed_loop());
  ASSERT_FALSE(encoding.compressed.forms.empty());
  EXPECT_EQ(encoding.compressed.skeleton.joint(0).channels, motion.skeleton.joint(0).channels);
  const CompressedClip read = read_container(write_container(encoding.compressed));
  EXPECT_EQ(read.forms, encoding.compressed.forms);
  EXPECT_EQ(read.skeleton.joint(0).channels, motion.skeleton.joint(0).channels);
  const Clip decoded = decode(read);
  EXPECT_EQ(decoded.channels, encoding.decoded.channels);
  EXPECT_NEAR(measure(motion.skeleton, motion.clip, decoded).eps_bone_ends,
              encoding.distortion.eps_bone_ends, 1e-3);
  EXPECT_LE(encoding.distortion.eps_bone_ends, 0.2);
}

TEST(FormChoice, TheRuntimeDecoderPlaysWhatIsCoded) {
  const Encoding encoding = Encoder(near_the_pole()).encode(closed_loop());
  const RuntimeClip clip(write_container(encoding.compressed));
  EXPECT_TRUE(clip.has_joints_of(encoding.compressed.coded_skeleton()));
  const Eigen::MatrixXd frames = clip.frames(0, encoding.compressed.frames);
  EXPECT_TRUE(landmark_tracks(encoding.compressed.coded_skeleton(), {120, frames})
                  .isApprox(landmark_tracks(encoding.compressed.skeleton, encoding.decoded), 1e-5));
}

TEST(FormChoice, IsForClosedLoopsAlone) {
  EncodeSettings standard = closed_loop();
  standard.method = Method::Standard;
  EXPECT_TRUE(Encoder(near_the_pole()).encode(standard).compressed.forms.empty());
}

}  // namespace
}  // namespace mocapress::form_choice_test
