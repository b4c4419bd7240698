// SPDX-License-Identifier: MIT
// Decoded quaternions are continuous from frame to frame.
#include <gtest/gtest.h>

#include <numbers>

#include "core/codec/encode/encoder.h"
#include "core/codec/format/container.h"
#include "core/formats/motion_file.h"
#include "core/runtime/mocapress_runtime.h"
#include "tests/support/corpus.h"
#include "tests/support/opened_clip.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// The least dot product of consecutive quaternions, over all joints and frames. Negative if a
/// quaternion flips its sign.
float least_cosine(const Motion& motion) {
  const test::OpenedClip clip(write_container(Encoder(motion)
                                                  .encode({.method = Method::Annealed,
                                                           .coding = Coding::Adaptive,
                                                           .weighting = Weighting::BoneEnds,
                                                           .target = {Target::Kind::Error, 0.5}})
                                                  .compressed));
  const auto frames = static_cast<std::uint32_t>(motion.clip.frames());
  const std::vector<float> rows = clip.frames({.output = MCPR_LOCAL}, 0, frames);
  const std::size_t width = rows.size() / frames;
  float least = 1;
  for (std::size_t t = 1; t < frames; ++t)
    for (std::size_t at = 0; at < width; at += 7) {
      const Eigen::Map<const Eigen::Vector4f> now(&rows[t * width + at]);
      const Eigen::Map<const Eigen::Vector4f> before(&rows[(t - 1) * width + at]);
      EXPECT_NEAR(now.norm(), 1, 1e-5);
      least = std::min(least, now.dot(before));
    }
  return least;
}

TEST(Quaternions, NeverFlipSignHoweverOftenAJointTurns) {
  Motion motion = test::smooth_motion(200);
  const int joint = motion.skeleton.joint_count() - 1;
  for (int c = motion.skeleton.first_channel(joint); c < motion.skeleton.channel_count(); ++c)
    motion.clip.channels.col(c) += Eigen::VectorXd::LinSpaced(200, 0, 20 * std::numbers::pi);
  EXPECT_GT(least_cosine(motion), 0.5F);
}

TEST(Quaternions, NeverFlipSignInRealClips) {
  const auto folder = test::corpus();
  if (!folder) GTEST_SKIP() << "the corpus of real motions is not here";
  for (const char* clip : {"fbx/85_12.fbx", "fbx/huesitos.fbx", "fbx/animation_with_skeleton.fbx",
                           "gltf/simple_skin.gltf", "study/09_01.amc"}) {
    const std::filesystem::path path = *folder / clip;
    if (!std::filesystem::exists(path)) continue;
    EXPECT_GT(least_cosine(read_motion(path).motion), 0.5F) << clip;
  }
}

}  // namespace
}  // namespace mocapress
