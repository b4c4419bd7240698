// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure_front.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "core/formats/motion_file.h"
#include "core/motion/landmarks.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

Motion sampleRun() {
  return read_motion(std::filesystem::path(MOCAPRESS_SOURCE_DIR) /
                     "resources/samples/human_run.amc")
      .motion;
}

Eigen::MatrixXd tracksOf(const Motion& motion) {
  return landmark_tracks(motion.skeleton, motion.clip);
}

/// Turned about the vertical axis.
Eigen::MatrixXd turned(Eigen::MatrixXd tracks, double radians) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(radians, Eigen::Vector3d::UnitY()).toRotationMatrix();
  for (Eigen::Index c = 0; c < tracks.cols(); c += 3)
    tracks.middleCols(c, 3) = (tracks.middleCols(c, 3) * turn.transpose()).eval();
  return tracks;
}

double between(double a, double b) {
  return std::remainder(a - b, 2 * std::numbers::pi);
}

TEST(FigureFront, ARunnerFacesWhereItRuns) {
  const Motion run = sampleRun();
  const Eigen::MatrixXd tracks = tracksOf(run);
  const Eigen::RowVectorXd way = tracks.row(tracks.rows() - 1) - tracks.row(0);
  const auto front = frontOf(run.skeleton, tracks);
  ASSERT_TRUE(front);
  EXPECT_NEAR(between(*front, std::atan2(way[0], way[2])), 0, 0.2);
}

TEST(FigureFront, TurnsWithTheFigure) {
  const Motion run = sampleRun();
  const Eigen::MatrixXd tracks = tracksOf(run);
  const double before = frontOf(run.skeleton, tracks).value();
  for (const double angle : {0.5, 2.0, 3.1, -1.5})
    EXPECT_NEAR(between(frontOf(run.skeleton, turned(tracks, angle)).value(), before + angle), 0,
                1e-4);
}

TEST(FigureFront, ABodyWithoutLegsHasNone) {
  const Motion motion = test::smooth_motion(10, 1);
  EXPECT_FALSE(frontOf(motion.skeleton, tracksOf(motion)));
}

}  // namespace
}  // namespace mocapress
