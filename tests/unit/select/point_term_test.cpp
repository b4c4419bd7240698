// SPDX-License-Identifier: MIT
#include "core/select/point_term.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/select/error_model.h"
#include "tests/support/landmark_jacobian.h"
#include "tests/support/test_motion.h"

namespace mocapress::point_term_test {
namespace {

constexpr int kFrames = 70;

Eigen::MatrixXd any_numbers(Eigen::Index rows, Eigen::Index columns, double size, unsigned seed) {
  Random random(seed);
  Eigen::MatrixXd numbers(rows, columns);
  for (double& number : numbers.reshaped()) number = size * (random.unit() - 0.5);
  return numbers;
}

/// The quadratic form of a model at a frame, column by column.
Eigen::MatrixXd form_of(const ErrorModel& model, int frame) {
  Eigen::MatrixXd form(model.channels(), model.channels());
  for (int c = 0; c < model.channels(); ++c) {
    Eigen::MatrixXd gradient = Eigen::MatrixXd::Zero(kFrames, model.channels());
    model.add_to_gradient(c, Eigen::VectorXd::Unit(kFrames, frame), gradient);
    form.col(c) = gradient.row(frame).transpose();
  }
  return form;
}

class PointTermOf : public testing::Test {
 protected:
  /// A response of the joints at the ends of both limbs.
  PointResponse response(std::vector<int> joints, std::vector<int> angles) const {
    const Eigen::MatrixXd tracks = landmark_tracks(motion_.skeleton, motion_.clip);
    const auto points = std::ssize(joints);
    PointResponse made{
        .joints = joints, .places = {}, .angles = angles, .turns = {}, .weights = {}};
    made.places.resize(kFrames, 3 * points);
    for (Eigen::Index p = 0; p < points; ++p)
      made.places.middleCols(3 * p, 3) =
          tracks.middleCols(3 * joints[static_cast<std::size_t>(p)], 3);
    made.turns = any_numbers(kFrames, 3 * points * std::ssize(angles), 0.05, 5);
    made.weights = any_numbers(kFrames, points, 1, 6).cwiseAbs();
    return made;
  }

  const Motion motion_ = test::smooth_motion(kFrames);
  ErrorModel model_{motion_.skeleton, motion_.clip, Weighting::BoneEnds};
};

TEST_F(PointTermOf, IsTheErrorThatACorrectionLeavesAndWhatItIsGivenToCorrect) {
  const int last = motion_.skeleton.joint_count() - 1;
  const int above = motion_.skeleton.joint(last).parent;
  std::vector<int> angles;
  for (int c = 0; c < motion_.skeleton.channel_count(); ++c)
    if (motion_.skeleton.channel_joint(c) == above) angles.push_back(c);
  ASSERT_FALSE(angles.empty());
  for (const std::vector<int>& joints : {std::vector{last}, std::vector{above, last}}) {
    const PointResponse response = this->response(joints, angles);
    ErrorModel corrected = model_;
    corrected.add(response);
    for (const int t : {0, 33, kFrames - 1}) {
      const Eigen::MatrixXd jacobian = test::landmark_jacobian(motion_, t);
      const Eigen::Index rows = 3 * std::ssize(joints);
      Eigen::MatrixXd of_points(rows, jacobian.cols());
      Eigen::MatrixXd turns = Eigen::MatrixXd::Zero(jacobian.cols(), rows);
      Eigen::VectorXd weights(rows);
      for (Eigen::Index p = 0; p < std::ssize(joints); ++p) {
        of_points.middleRows(3 * p, 3) =
            jacobian.middleRows(3 * joints[static_cast<std::size_t>(p)], 3);
        weights.segment(3 * p, 3).setConstant(response.weights(t, p));
      }
      for (std::size_t a = 0; a < angles.size(); ++a)
        turns.row(angles[a]) =
            response.turns.row(t).segment(rows * static_cast<Eigen::Index>(a), rows);
      const auto left =
          Eigen::MatrixXd::Identity(jacobian.cols(), jacobian.cols()) - turns * of_points;
      const Eigen::MatrixXd expected = left.transpose() * form_of(model_, t) * left +
                                       of_points.transpose() * weights.asDiagonal() * of_points;
      const Eigen::MatrixXd form = form_of(corrected, t);
      EXPECT_TRUE(form.isApprox(expected, 1e-5));
      EXPECT_TRUE(corrected.curvature().row(t).transpose().isApprox(form.diagonal(), 1e-5));
    }
  }
}

TEST_F(PointTermOf, WithoutAnglesIsAWeightOfThePoint) {
  const int joint = motion_.skeleton.joint_count() - 1;
  PointResponse response = this->response({joint}, {});
  response.weights.setConstant(2);
  ErrorModel weighted = model_;
  weighted.add(response);
  const Eigen::MatrixXd velocity =
      test::landmark_jacobian(motion_, 9).middleRows(Eigen::Index{3} * joint, 3);
  EXPECT_TRUE(form_of(weighted, 9)
                  .isApprox(form_of(model_, 9) + 2 * velocity.transpose() * velocity, 1e-5));
}

TEST_F(PointTermOf, SumIsThatOfTheFormsOfSomeChannels) {
  const int last = motion_.skeleton.joint_count() - 1;
  const int above = motion_.skeleton.joint(last).parent;
  ErrorModel model = model_;
  model.add(response({last}, {model.channels() - 1}));
  model.add(response({above}, {}));
  const std::vector<int> channels = {0, 3, 4, model.channels() - 1};
  for (const auto& [size, apart] : {std::pair{11, 2}, std::pair{49, 4}}) {
    const Eigen::ArrayXf values = Eigen::ArrayXf::LinSpaced(size, 0.5F, 2);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(4, 4);
    for (int i = 0; i < size; i += apart)
      expected +=
          static_cast<double>(values(i) * values(i)) * form_of(model, 20 + i)(channels, channels);
    const ShortFunction function(20, size, values.data());
    Eigen::MatrixXf sums = Eigen::MatrixXf::Zero(5, 4);
    model.sum_squares(channels, function, sums);
    EXPECT_TRUE(sums.topRows(4).isApprox(expected.cast<float>(), 1e-4F));
    EXPECT_TRUE(sums.bottomRows(1).isZero(0));
  }
}

}  // namespace
}  // namespace mocapress::point_term_test
