// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/promises.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "core/base/error.h"
#include "core/codec/encode/encoder.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/game_like.h"

namespace mocapress {
namespace {

EncodeSettings options_with(const Promises& promises) {
  return {.method = Method::ClosedLoop,
          .weighting = Weighting::Surface,
          .target = {Target::Kind::Error, 0.5},
          .promises = promises};
}

TEST(Promises, EachHandIsLookedAtByItself) {
  Skeleton skeleton;
  for (const char* name : {"root", "lwrist", "lhand", "rhand"}) {
    Joint joint;
    joint.name = name;
    joint.parent = skeleton.joint_count() - 1;
    skeleton.add(joint);
  }
  Distortion distortion;
  distortion.joint_degrees.resize(4);
  distortion.joint_degrees << 0, 9, 1, 5;
  distortion.joint_max_degrees = distortion.joint_degrees;
  distortion.joint_max_cm = Eigen::VectorXd::Zero(4);
  const Motion motion{skeleton, {}};
  const auto broken = broken_promises({.hand_degrees = 4}, motion, distortion);
  ASSERT_EQ(broken.size(), 1u);  // neither the wrist nor the mean of both hands
  EXPECT_EQ(broken[0].joint, 3);
  EXPECT_DOUBLE_EQ(broken[0].times, 1.25);
  EXPECT_EQ(broken[0].text, "rhand is turned (degrees, RMS) by 5, not 4");
  EXPECT_DOUBLE_EQ(body_figures(skeleton, distortion).hand->rms_degrees, 5);
}

TEST(Promises, AreKeptWhereTheTargetAloneWouldBreakThem) {
  const Motion motion = test::game_like(samples::run_clip());
  const Encoder encoder(motion);
  const Promises promises{
      .head_degrees = 1, .hand_degrees = 3, .root_cm = 0.2, .root_degrees = 0.3};
  const Encoding plain = encoder.encode(options_with({}));
  ASSERT_GE(broken_promises(promises, motion, plain.distortion).size(), 3u);
  const Encoding kept = encoder.encode(options_with(promises));
  EXPECT_THAT(broken_promises(promises, motion, kept.distortion), testing::IsEmpty());
  EXPECT_LE(kept.distortion.surface.rms, 0.5);
  std::printf("promises kept at %zu bytes instead of %zu\n", kept.compressed.motion_bytes(),
              plain.compressed.motion_bytes());
}

TEST(Promises, RootPromisesHoldOnlyForRootsOnTheFloor) {
  const Motion hips = samples::run_clip();
  const Encoder encoder(hips);
  const Encoding plain = encoder.encode(options_with({}));
  EXPECT_THAT(broken_promises({.root_cm = 1e-9}, hips, plain.distortion), testing::IsEmpty());
}

TEST(Promises, OutOfReachAreATargetThatIsMissed) {
  const Encoder encoder(samples::walk_clip());
  EXPECT_THROW(encoder.encode(options_with({.head_degrees = 1e-9})), TargetMissed);
}

TEST(Promises, AreNotKeptBesideASize) {
  const Encoder encoder(samples::walk_clip());
  EncodeSettings options = options_with({.head_degrees = 1e-9});
  options.target = {Target::Kind::Ratio, 100};
  EXPECT_NO_THROW(encoder.encode(options));
}

}  // namespace
}  // namespace mocapress
