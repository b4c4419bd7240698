// SPDX-License-Identifier: MIT
#include "core/metrics/end_errors.h"

#include <gtest/gtest.h>

#include "core/metrics/distortion.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

/// End errors of a clip whose root is shifted along x by so much (cm) at each frame.
EndErrors errors_of_shifts(const Eigen::VectorXd& shifts) {
  const Motion motion = test::smooth_motion(static_cast<int>(shifts.size()));
  Clip decoded = motion.clip;
  decoded.channels.col(0) += shifts;
  return measure(motion.skeleton, motion.clip, decoded).ends;
}

TEST(EndErrors, AreNothingWhereNothingIsOff) {
  const EndErrors ends = errors_of_shifts(Eigen::VectorXd::Zero(20));
  EXPECT_NEAR(ends.first_cm + ends.last_cm + ends.seam_cm + ends.neighbours_cm, 0, 1e-9);
}

TEST(EndErrors, TellHowFarFirstAndLastPoseAreOff) {
  Eigen::VectorXd shifts = Eigen::VectorXd::Constant(20, 0.5);
  shifts(0) = 2;
  shifts(19) = 3;
  const EndErrors ends = errors_of_shifts(shifts);
  EXPECT_NEAR(ends.first_cm, 2, 1e-6);
  EXPECT_NEAR(ends.last_cm, 3, 1e-6);
}

TEST(EndErrors, MeasureTheChangeAcrossTheSeam) {
  Eigen::VectorXd shifts = Eigen::VectorXd::LinSpaced(20, 0, 1.9);  // 0.1 a frame
  const EndErrors drifting = errors_of_shifts(shifts);
  EXPECT_NEAR(drifting.seam_cm, 1.9, 1e-6);
  EXPECT_NEAR(drifting.seam_cm_per_frame, 0, 1e-6);
  EXPECT_NEAR(drifting.neighbours_cm, 0.1, 1e-6);
  EXPECT_NEAR(drifting.neighbours_cm_per_frame, 0, 1e-6);
  shifts(0) = 1;  // 0.1 in the other frames
  const EndErrors jumping = errors_of_shifts(shifts);
  EXPECT_NEAR(jumping.seam_cm, 0.9, 1e-6);
  EXPECT_NEAR(jumping.seam_cm_per_frame, 1, 1e-6);  // -0.9 beside 0.1
}

TEST(EndErrors, AreTheSameWhateverTheBlocks) {
  const Motion motion = test::smooth_motion(50);
  Clip decoded = motion.clip;
  decoded.channels += 0.01 * Eigen::MatrixXd::Random(50, decoded.channels.cols());
  const Eigen::MatrixXd there = body_tracks(motion.skeleton, motion.clip);
  const Eigen::MatrixXd found = body_tracks(motion.skeleton, decoded);
  DistortionMeter meter(motion.skeleton, 50, Detail::Figures);
  for (int t = 0; t < 50; ++t) meter.add(t, there.middleRows(t, 1), found.middleRows(t, 1));
  EXPECT_EQ(meter.distortion().ends, measure(motion.skeleton, there, found).ends);
}

}  // namespace
}  // namespace mocapress
