// SPDX-License-Identifier: MIT
#include "core/baselines/arikan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"
#include "core/metrics/distortion.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// Motions as in a database: a cycle of 96 frames, each time a little larger.
std::vector<Motion> similar_motions() {
  std::vector<Motion> motions;
  for (const double size : {1.0, 1.1, 1.2, 1.3}) {
    Motion motion = test::smooth_motion(250);
    for (int c = 0; c < motion.skeleton.channel_count(); ++c)
      for (int t = 0; t < 250; ++t)
        motion.clip.channels(t, c) =
            size * (0.4 * std::sin(0.0654498 * t + c) + 0.1 * std::sin(3 * 0.0654498 * t + 2 * c));
    motions.push_back(std::move(motion));
  }
  return motions;
}

double eps(const Motion& motion, const ArikanDatabase& database, std::size_t clip) {
  return measure(
             motion.skeleton, motion.clip,
             decode_from_database(motion.skeleton, motion.clip.sample_rate_hz, motion.clip.frames(),
                                  database.codebook, database.clips[clip]))
      .eps_bone_ends;
}

TEST(ArikanDatabase, EveryMotionComesBackWithinItsTolerance) {
  const std::vector<Motion> motions = similar_motions();
  for (const double tolerance : {2.0, 0.5}) {
    const ArikanDatabase database = compress_database(motions, Weighting::BoneEnds, tolerance);
    ASSERT_EQ(database.clips.size(), motions.size());
    for (std::size_t m = 0; m < motions.size(); ++m)
      EXPECT_LT(eps(motions[m], database, m), 2 * tolerance);
  }
}

TEST(ArikanDatabase, SharedComponentsTakeLessThanEachMotionsOwn) {
  const std::vector<Motion> motions = similar_motions();
  std::size_t alone = 0;
  for (const Motion& motion : motions)
    alone += compress_database(std::span(&motion, 1), Weighting::BoneEnds, 0.5).bytes();
  const ArikanDatabase together = compress_database(motions, Weighting::BoneEnds, 0.5);
  EXPECT_LT(static_cast<double>(together.bytes()), 0.6 * static_cast<double>(alone));
}

TEST(ArikanDatabase, MotionsOfAnotherSkeletonAreRefused) {
  std::vector<Motion> motions(2, test::smooth_motion(20));
  motions[1] = {};
  motions[1].skeleton.add({.name = "root"});
  motions[1].clip.channels.resize(20, 0);
  EXPECT_THROW(compress_database(motions, Weighting::BoneEnds, 1), Error);
}

TEST(ArikanDatabase, AClipOfAnotherCodebookIsRefusedOrDecodedButNothingElse) {
  const Motion motion = test::smooth_motion(200);
  const ArikanDatabase coarse = compress_database(std::span(&motion, 1), Weighting::BoneEnds, 5);
  const ArikanDatabase fine = compress_database(std::span(&motion, 1), Weighting::BoneEnds, 0.1);
  EXPECT_THROW(decode_from_database(motion.skeleton, 120, 200, coarse.codebook, fine.clips[0]),
               FormatError);
  EXPECT_THROW(decode_from_database(motion.skeleton, 120, 200, fine.clips[0], fine.codebook),
               FormatError);
}

}  // namespace
}  // namespace mocapress
