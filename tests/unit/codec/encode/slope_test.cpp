// SPDX-License-Identifier: MIT
#include "core/codec/encode/slope.h"

#include <gtest/gtest.h>

#include "core/metrics/rate.h"
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

TEST_F(SlopeTest, RelaxingSomeJointsSavesBytesAndLeavesTheOthersAsTheyAre) {
  const Standing now = standing(settings_);
  const Slope slope = relax(encoder_, settings_, now, limb_, 2);
  const std::vector<int> others = {0, 1, 5, 6, 7};
  EXPECT_LT(slope.standing.bytes, now.bytes);
  EXPECT_GT(slope.standing.cm_of(limb_), 1.3 * now.cm_of(limb_));
  EXPECT_LT(slope.standing.cm_of(limb_), 3 * now.cm_of(limb_));
  EXPECT_NEAR(slope.standing.cm_of(others), now.cm_of(others), 0.35 * now.cm_of(others));
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
