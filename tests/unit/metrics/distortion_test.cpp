// SPDX-License-Identifier: MIT
#include "core/metrics/distortion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/random.h"
#include "tests/support/test_motion.h"

namespace mocapress {
namespace {

TEST(DistanceCounts, GivePercentilesToTheirPrecisionAndNeverMore) {
  Random random(1);
  for (const double spread : {0.1, 2.0, 12.0}) {
    std::vector<float> distances;
    DistanceCounts counts;
    for (int i = 0; i < 10'000; ++i) {
      distances.push_back(static_cast<float>(0.3 * std::exp(spread * (random.unit() - 0.5))));
      counts.add(distances.back());
    }
    std::sort(distances.begin(), distances.end());
    for (const double share : {0.0, 0.001, 0.5, 0.95, 0.99, 1.0}) {
      const auto rank = std::max(1.0, std::ceil(share * 10'000));
      const auto exact = static_cast<double>(distances[static_cast<std::size_t>(rank) - 1]);
      EXPECT_LE(counts.percentile(share), exact) << share;
      EXPECT_GT(counts.percentile(share), (1 - DistanceCounts::kPrecision) * exact) << share;
    }
  }
}

TEST(DistanceCounts, ZeroAndNoneAreZero) {
  DistanceCounts counts;
  EXPECT_EQ(counts.percentile(0.95), 0);
  for (int i = 0; i < 99; ++i) counts.add(0);
  counts.add(7);
  EXPECT_EQ(counts.percentile(0.99), 0);
  EXPECT_EQ(counts.percentile(1), 7);
}

TEST(DistanceCounts, NotANumberIsLargerThanAnyDistance) {
  DistanceCounts counts;
  counts.add(1);
  for (const float sign : {1.0F, -1.0F})
    counts.add(std::copysign(std::numeric_limits<float>::quiet_NaN(), sign));
  EXPECT_EQ(counts.percentile(0.3), 1);
  EXPECT_FALSE(counts.percentile(1) < std::numeric_limits<double>::infinity());
}

TEST(Distortion, IsZeroForEqualClips) {
  const Motion motion = test::smooth_motion(30);
  const Distortion distortion = measure(motion.skeleton, motion.clip, motion.clip);
  EXPECT_EQ(distortion.eps_bone_ends, 0);
  EXPECT_EQ(distortion.eps_joint_origins, 0);
  EXPECT_EQ(distortion.max.cm, 0);
}

TEST(Distortion, EqualsTheShiftOfAShiftedFigureInEveryMeasure) {
  const Motion motion = test::smooth_motion(30);
  Clip shifted = motion.clip;
  shifted.channels.col(0).array() += 3;
  shifted.channels.col(2).array() -= 4;
  const Distortion distortion = measure(motion.skeleton, motion.clip, shifted);
  EXPECT_NEAR(distortion.eps_bone_ends, 5, 1e-9);
  EXPECT_NEAR(distortion.eps_joint_origins, 5, 1e-9);
  EXPECT_NEAR(distortion.p95, 5, 1e-5);
  EXPECT_NEAR(distortion.p99, 5, 1e-5);
  EXPECT_NEAR(distortion.max.cm, 5, 1e-9);
}

TEST(Distortion, FollowsThePapersFormula) {
  const Motion motion = test::smooth_motion(20);
  const Clip other = test::smooth_motion(20, 2).clip;
  const Eigen::MatrixXd a = body_tracks(motion.skeleton, motion.clip);
  const Eigen::MatrixXd b = body_tracks(motion.skeleton, other);
  for (const Weighting weighting : {Weighting::BoneEnds, Weighting::JointOrigins}) {
    const Eigen::VectorXd weights = landmark_weights(motion.skeleton, weighting);
    double sum = 0;
    for (int t = 0; t < 20; ++t)
      for (int p = 0; p < weights.size(); ++p)
        sum += weights(p) * (a.block<1, 3>(t, 3 * p) - b.block<1, 3>(t, 3 * p)).squaredNorm();
    const double eps = std::sqrt(sum / 20);
    EXPECT_NEAR(measure(motion.skeleton, motion.clip, other).eps(weighting), eps, 1e-9);
    EXPECT_NEAR(exact_eps(motion.skeleton, a, other, weighting), eps, 1e-9);
  }
}

TEST(Distortion, MeasuresPointsOnTheBodyByTheirTracks) {
  const Motion motion = test::smooth_motion(20);
  const Clip other = test::smooth_motion(20, 2).clip;
  const Distortion distortion = measure(motion.skeleton, motion.clip, other);
  for (const Weighting weighting : {Weighting::Surface, Weighting::Shell}) {
    const auto [points, weights] = measured_points(motion.skeleton, weighting);
    const Eigen::MatrixXd between = point_tracks(motion.skeleton, points, other) -
                                    point_tracks(motion.skeleton, points, motion.clip);
    double sum = 0;
    double most = 0;
    for (Eigen::Index p = 0; p < weights.size(); ++p) {
      const Eigen::VectorXd squared = between.middleCols<3>(3 * p).rowwise().squaredNorm();
      sum += weights(p) * squared.mean();
      most = std::max(most, squared.maxCoeff());
    }
    EXPECT_NEAR(distortion.eps(weighting), std::sqrt(sum), 1e-9);
    EXPECT_NEAR(distortion.worst(weighting).cm, std::sqrt(most), 1e-9);
    EXPECT_NEAR(
        exact_eps(motion.skeleton, body_tracks(motion.skeleton, motion.clip), other, weighting),
        std::sqrt(sum), 1e-9);
  }
}

TEST(Distortion, KnowsByHowMuchEachJointIsTurned) {
  const Motion motion = test::smooth_motion(30);
  Clip turned = motion.clip;
  const int hand = motion.skeleton.find("rhand");
  turned.channels.col(motion.skeleton.first_channel(hand)).array() += 0.1;
  const Distortion distortion = measure(motion.skeleton, motion.clip, turned);
  for (int j = 0; j < motion.skeleton.joint_count(); ++j)
    EXPECT_NEAR(distortion.joint_degrees(j), j == hand ? 5.7296 : 0, 1e-4);
}

TEST(Distortion, KnowsByHowMuchEachJointIsTurnedAtEveryFrame) {
  const Motion motion = test::smooth_motion(30);
  Clip turned = motion.clip;
  const int hand = motion.skeleton.find("rhand");
  turned.channels(17, motion.skeleton.first_channel(hand)) += 0.1;
  turned.channels(20, motion.skeleton.first_channel(hand)) += 3;
  const Distortion distortion = measure(motion.skeleton, motion.clip, turned);
  ASSERT_EQ(distortion.turns.rows(), 30);
  ASSERT_EQ(distortion.turns.cols(), distortion.distances.cols());
  EXPECT_NEAR(distortion.turns(17, hand), 5.7296, 1e-4);
  EXPECT_NEAR(distortion.turns(20, hand), 171.887, 1e-3);
  const std::vector<Landmark> points = landmarks(motion.skeleton);
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Eigen::VectorXd turns = distortion.turns.col(static_cast<Eigen::Index>(p)).cast<double>();
    EXPECT_NEAR(std::sqrt(turns.squaredNorm() / 30), distortion.joint_degrees(points[p].joint),
                1e-4)
        << points[p].name;
  }
}

TEST(Distortion, PointsAtTheWorstFrameAndLandmark) {
  const Motion motion = test::smooth_motion(30);
  Clip bent = motion.clip;
  const int hand = motion.skeleton.find("rhand");
  bent.channels(17, motion.skeleton.first_channel(hand)) += 0.5;
  const WorstPoint worst = measure(motion.skeleton, motion.clip, bent).max;
  EXPECT_EQ(worst.frame, 17);
  EXPECT_EQ(landmarks(motion.skeleton)[static_cast<std::size_t>(worst.landmark)].name, "rhand end");
}

TEST(Distortion, PercentilesLeaveRareGlitchesToTheMaximum) {
  const Motion motion = test::smooth_motion(400);
  Clip glitch = motion.clip;
  glitch.channels(200, 0) += 50;  // one frame in 400: 0.25 % of all points
  const Distortion distortion = measure(motion.skeleton, motion.clip, glitch);
  EXPECT_EQ(distortion.p99, 0);
  EXPECT_NEAR(distortion.max.cm, 50, 1e-9);
}

TEST(Distortion, IsZeroWithoutFrames) {
  const Motion motion = test::smooth_motion(0);
  EXPECT_EQ(measure(motion.skeleton, motion.clip, motion.clip).eps_bone_ends, 0);
}

TEST(Distortion, FiguresOfBlocksAreThoseOfTheWhole) {
  const Motion motion = test::smooth_motion(200);
  const Eigen::MatrixXd original = body_tracks(motion.skeleton, motion.clip);
  const Eigen::MatrixXd decoded = body_tracks(motion.skeleton, test::smooth_motion(200, 2).clip);
  const Distortion whole = measure(motion.skeleton, original, decoded);
  DistortionMeter meter(motion.skeleton, 200, Detail::Figures);
  for (const auto& [first, count] : {std::pair(0, 70), {70, 1}, {71, 129}})
    meter.add(first, original.middleRows(first, count), decoded.middleRows(first, count));
  const Distortion figures = meter.distortion();
  EXPECT_NEAR(figures.eps_bone_ends, whole.eps_bone_ends, 1e-12 * whole.eps_bone_ends);
  EXPECT_NEAR(figures.eps_joint_origins, whole.eps_joint_origins, 1e-12 * whole.eps_joint_origins);
  EXPECT_EQ(figures.max.cm, whole.max.cm);
  EXPECT_EQ(figures.max.frame, whole.max.frame);
  EXPECT_EQ(figures.max.landmark, whole.max.landmark);
  EXPECT_NEAR(figures.p95, whole.p95, DistanceCounts::kPrecision * whole.p95);
  EXPECT_NEAR(figures.p99, whole.p99, DistanceCounts::kPrecision * whole.p99);
  EXPECT_EQ(figures.distances.size(), 0);
  EXPECT_EQ(figures.turns.size(), 0);
  EXPECT_EQ(figures.surface.max, whole.surface.max);
  EXPECT_NEAR(figures.shell.rms, whole.shell.rms, 1e-12);
  EXPECT_EQ(figures.shell.p99, whole.shell.p99);
  EXPECT_TRUE(figures.joint_degrees.isApprox(whole.joint_degrees));
}

}  // namespace
}  // namespace mocapress
