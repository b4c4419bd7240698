// SPDX-License-Identifier: MIT
#include "core/baselines/rivals.h"

#include <gtest/gtest.h>

#include "core/codec/format/deflate.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// Poses made from two curves, with a root that travels freely.
Motion two_component_motion() {
  Motion motion = test::smooth_motion(300);
  for (int c = 3; c < motion.skeleton.channel_count(); ++c)
    for (int t = 0; t < 300; ++t)
      motion.clip.channels(t, c) = 0.2 * c + 0.5 * std::sin(1.0 * c) * std::sin(0.03 * t) +
                                   0.3 * std::cos(2.0 * c) * std::cos(0.07 * t);
  return motion;
}

TEST(Pca, AsManyComponentsAsThePosesHaveAreEnough) {
  const Motion motion = two_component_motion();
  const auto coder = kPca.analyse(motion, Weighting::BoneEnds);
  EXPECT_EQ(coder->most_detail(), 2);
  const auto eps = [&](int components) {
    return measure(motion.skeleton, motion.clip,
                   kPca.decode(motion.skeleton, 120, 300, coder->encode(components)))
        .eps_bone_ends;
  };
  EXPECT_GT(eps(1), 1);
  EXPECT_LT(eps(2), 0.02);
}

TEST(Pca, CountsMeanBasisProjectionsAndRoot) {
  const Motion motion = test::smooth_motion(300);
  const auto coder = kPca.analyse(motion, Weighting::BoneEnds);
  for (const int components : {0, 3, 7}) {
    // 18 angles and 3 translations, 16 bits each. A range each for the mean, the basis, the
    // projections and the translations.
    const auto expected = static_cast<std::size_t>(
        2 + 2 * (18 + 18 * components + 300 * components + 3 * 300) + 8 * (3 + 3));
    EXPECT_EQ(inflate_bytes(coder->encode(components), 1 << 20).size(), expected);
  }
}

}  // namespace
}  // namespace mocapress
