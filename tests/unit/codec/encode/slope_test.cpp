// SPDX-License-Identifier: MIT
#include "core/codec/encode/slope.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/metrics/rate.h"
#include "core/motion/body_part.h"
#include "resources/samples/generator/samples.h"
#include "tests/support/test_motion.h"

namespace mocapress::slope_test {
namespace {

class SlopeTest : public testing::Test {
 protected:
  Standing standing(const EncodeSettings& settings) const {
    const Encoding encoding = encoder_.encode(settings);
    return standing_of(motion_.skeleton, encoding.distortion, settings.weighting,
                       encoding.compressed.motion_bytes());
  }

  Motion motion_ = test::smooth_motion(240);
  Encoder encoder_{motion_};
  EncodeSettings settings_{.weighting = Weighting::BoneEnds, .target = {Target::Kind::Error, 0.2}};
  std::vector<int> limb_ = {2, 3, 4};
};

TEST(Slope, RelaxingTheFeetSavesBytesAndLeavesTheOthersAsTheyAre) {
  const Encoder walk(samples::walk_clip());
  const Skeleton& skeleton = walk.motion().skeleton;
  const EncodeSettings settings{.weighting = Weighting::BoneEnds,
                                .target = {Target::Kind::Error, 0.2}};
  const Encoding encoding = walk.encode(settings);
  const Standing now = standing_of(skeleton, encoding.distortion, settings.weighting,
                                   encoding.compressed.motion_bytes());
  const std::vector<int> feet = joints_of(skeleton, BodyPart::Feet);
  std::vector<int> others;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (std::find(feet.begin(), feet.end(), j) == feet.end()) others.push_back(j);
  const Standing relaxed = relax(walk, settings, now, feet, 2).standing;
  EXPECT_LT(relaxed.bytes, 0.98 * now.bytes);
  EXPECT_GT(relaxed.cm_of(feet), 1.3 * now.cm_of(feet));
  EXPECT_LT(relaxed.cm_of(feet), 2 * now.cm_of(feet));
  EXPECT_NEAR(relaxed.cm_of(others), now.cm_of(others), 0.1 * now.cm_of(others));
}

TEST_F(SlopeTest, SettingsGiveWhatWasMeasured) {
  const Standing now = standing(settings_);
  for (const Target target : {Target{Target::Kind::Error, 0.2}, Target{Target::Kind::Ratio, 20}}) {
    settings_.target = target;
    const Slope slope = relax(encoder_, settings_, now, limb_, 2);
    EXPECT_EQ(slope.settings.target.kind, target.kind);
    EXPECT_NEAR(standing(slope.settings).bytes, slope.standing.bytes, 0.04 * slope.standing.bytes);
  }
}

TEST_F(SlopeTest, MoreBytesBringLessError) {
  const Standing now = standing(settings_);
  const Slope more = resize(encoder_, settings_, now, 1.1);
  EXPECT_LE(more.standing.bytes, 1.1 * now.bytes);
  EXPECT_GT(more.standing.bytes, 1.05 * now.bytes);
  EXPECT_LT(more.standing.eps_cm, now.eps_cm);
  EXPECT_EQ(more.settings.target.kind, Target::Kind::Error);
  const Slope fewer = resize(encoder_, settings_, now, 0.9);
  EXPECT_GT(fewer.standing.eps_cm, now.eps_cm);
}

TEST_F(SlopeTest, PromisesOfRelaxedPartsAreRaised) {
  settings_.promises.hand_degrees = 4;
  settings_.promises.head_degrees = 2;
  const int hand = motion_.skeleton.find("rhand");
  ASSERT_GE(hand, 0);
  const Slope slope = relax(encoder_, settings_, standing(settings_), {hand}, 2);
  EXPECT_EQ(slope.settings.promises.hand_degrees, 8);
  EXPECT_EQ(slope.settings.promises.head_degrees, 2);
}

TEST_F(SlopeTest, StandingIsTheRmsOfDistances) {
  const Encoding encoding = encoder_.encode(settings_);
  const Standing standing = standing_of(motion_.skeleton, encoding.distortion, settings_.weighting,
                                        encoding.compressed.motion_bytes());
  EXPECT_EQ(standing.eps_cm, encoding.distortion.eps(settings_.weighting));
  EXPECT_NEAR(standing.joints_cm(0),
              std::sqrt(encoding.distortion.distances.col(0).cast<double>().squaredNorm() / 240),
              1e-9);
  EXPECT_EQ(standing.cm_of({}), 0);
}

}  // namespace
}  // namespace mocapress::slope_test
