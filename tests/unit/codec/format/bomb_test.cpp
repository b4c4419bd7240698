// SPDX-License-Identifier: MIT
// Limits on the cost of a few bytes: memory by the samples they stand for (container_test), and
// time of the IK solver by the same.
#include <gtest/gtest.h>

#include "core/base/byte_cursor.h"
#include "core/codec/decode/decoder.h"
#include "core/codec/format/container.h"
#include "core/runtime/ik/solve.h"

namespace mocapress {
namespace {

constexpr int kArms = 4;
constexpr int kJointsOfArm = 8;

/// Arms of a centimetre a bone, each asked to reach for places kilometres away at every frame: one
/// word a channel, and the rest zeros.
CompressedClip unreachable_clip(int frames, IkSolver solver) {
  CompressedClip clip{.frames = frames, .coding = Coding::Rle16, .motion = {}};
  clip.skeleton.add({.name = "root"});
  CodedCorrection correction{.solver = solver, .effectors = {}};
  for (int arm = 0; arm < kArms; ++arm) {
    const int top = clip.skeleton.joint_count();
    for (int j = 0; j < kJointsOfArm; ++j)
      clip.skeleton.add({.name = "j",
                         .parent = j == 0 ? 0 : clip.skeleton.joint_count() - 1,
                         .offset = Eigen::Vector3d(1, arm, 0.1 * j),
                         .channels = {ChannelKind::RotationX, ChannelKind::RotationY}});
    correction.effectors.push_back(
        effector_between(clip.skeleton, top, clip.skeleton.joint_count() - 1));
  }
  clip.correction = correction;
  ByteWriter words;
  const auto append = [&](int count, std::int8_t exponent) {
    for (int s = 0; s < count; ++s) words.write(exponent);
    for (int s = 0; s < count; ++s) {
      words.write(static_cast<std::int16_t>(20000 + 37 * s));
      words.write(std::int16_t{-32768});
    }
  };
  append(clip.skeleton.channel_count(), -10);
  append(correction.signal_count(), 8);
  clip.motion = words.release();
  return clip;
}

TEST(Bomb, UnreachablePlacesTakeNoMoreStepsThanTheirSamplesAllow) {
  for (const IkSolver solver : {IkSolver::CyclicDescent, IkSolver::NearestPose}) {
    const CompressedClip clip = read_container(write_container(unreachable_clip(60, solver)));
    ASSERT_LT(clip.motion.size(), 400u);
    Uncorrected decoded = decode_uncorrected(clip);
    const CorrectionReport report = Finish(clip)(0, decoded);
    // A limb has three signals or more, so that samples bound its steps; and the samples of a file
    // are bounded by its bytes.
    const long most =
        long{clip.frames} * clip.correction->signal_count() / 3 * runtime::kMostSweeps;
    EXPECT_LE(report.iterations, most);
    EXPECT_GT(report.iterations, most / 20) << "no bomb";
    EXPECT_TRUE(decoded.clip.channels.allFinite());
  }
}

}  // namespace
}  // namespace mocapress
