// SPDX-License-Identifier: MIT
#include "core/baselines/quaternion.h"

#include <gtest/gtest.h>

#include "core/baselines/compression_method.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(Quaternion, TakesMoreThanAdaptedAnglesAtTheSameError) {
  const MethodEncoder encoder(test::smooth_motion(300));
  const EncodeOptions options{.target = {Target::Kind::Error, 0.5}};
  EXPECT_GT(encoder.compress(*find_compression_method("quaternion"), options).motion_bytes,
            encoder.compress(*find_compression_method("annealed"), options).motion_bytes);
}

TEST(Quaternion, GoesThroughWholeTurnsWithoutAJump) {
  Motion motion = test::smooth_motion(240);
  for (int t = 0; t < 240; ++t) motion.clip.channels(t, 4) = 0.1 * t;  // the root's heading
  const auto coder = quaternion_method().analyse(motion, Weighting::BoneEnds);
  const Clip decoded = quaternion_method().decode(motion.skeleton, 120, 240,
                                                  coder->encode(coder->most_detail() / 6));
  EXPECT_LT(measure(motion.skeleton, motion.clip, decoded).max.cm, 3);
}

TEST(Quaternion, LeavesOutSignalsThatMoveNoWeight) {
  // In joint-origins the hands' own turns move nothing that counts.
  const Motion motion = test::smooth_motion(200);
  const auto bytes = [&](Weighting weighting) {
    return MethodEncoder(motion)
        .compress(*find_compression_method("quaternion"),
                  {.weighting = weighting, .target = {Target::Kind::Error, 0.3}})
        .motion_bytes;
  };
  EXPECT_LT(bytes(Weighting::JointOrigins), bytes(Weighting::BoneEnds));
}

}  // namespace
}  // namespace mocapress
