// SPDX-License-Identifier: MIT
// Based on: C. Welman, "Inverse kinematics and geometric constraints for articulated figure
// manipulation", 1993 (cyclic coordinate descent), and S. R. Buss, "Introduction to inverse
// kinematics with Jacobian transpose, pseudoinverse and damped least squares methods", 2004.
#include "core/ik/solve.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace mocapress {
namespace {

using Targets = std::span<const Eigen::Vector3d>;

double miss(const Limb& limb, Targets targets) {
  double largest = 0;
  for (std::size_t e = 0; e < targets.size(); ++e)
    largest = std::max(largest, (targets[e] - limb.position(static_cast<int>(e))).norm());
  return largest;
}

/// The turn about the angle's axis that brings the effectors nearest to their targets, in the
/// least-squares sense.
double best_turn(const Limb& limb, int angle, Targets targets) {
  const Eigen::Vector3d& axis = limb.axis(angle);
  double along = 0;   // of the targets along where the effectors are
  double across = 0;  // and across, in the direction of turning
  for (std::size_t e = 0; e < targets.size(); ++e) {
    if (!limb.moves(angle, static_cast<int>(e))) continue;
    const Eigen::Vector3d arm = limb.position(static_cast<int>(e)) - limb.center(angle);
    const Eigen::Vector3d wanted = targets[e] - limb.center(angle);
    along += arm.dot(wanted) - axis.dot(arm) * axis.dot(wanted);
    across += axis.dot(arm.cross(wanted));
  }
  return along == 0 && across == 0 ? 0 : std::atan2(across, along);
}

IkOutcome solve_cyclic_descent(Limb& limb, Targets targets) {
  constexpr int kMostSweeps = 60;
  IkOutcome outcome{miss(limb, targets)};
  while (outcome.miss_cm > kReachedCm && outcome.iterations < kMostSweeps) {
    for (int a = limb.angle_count() - 1; a >= 0; --a) limb.turn(a, best_turn(limb, a, targets));
    outcome.miss_cm = miss(limb, targets);
    ++outcome.iterations;
  }
  return outcome;
}

constexpr double kLongestTurn = 0.35;  // radians in one step: beyond, a linearisation is void

/// The knee's turn by which the foot comes to be `reach` from the hip: of both the shorter one. A
/// target further off than the leg is long straightens it as far as the hinge allows.
double bend_for(const Limb& limb, double reach) {
  constexpr int kKnee = 3;
  const Eigen::Vector3d thigh = limb.center(kKnee) - limb.center(0);
  const Eigen::Vector3d shin = limb.position(0) - limb.center(kKnee);
  const Eigen::Vector3d& axis = limb.axis(kKnee);
  // |thigh + shin turned by t|^2 = constant + 2 (along cos t + across sin t)
  const double fixed = axis.dot(shin) * axis.dot(thigh);
  const double along = thigh.dot(shin) - fixed;
  const double across = thigh.dot(axis.cross(shin));
  const double size = std::hypot(along, across);
  if (size == 0) return 0;
  const double wanted = (reach * reach - thigh.squaredNorm() - shin.squaredNorm()) / 2 - fixed;
  const double spread = std::acos(std::clamp(wanted / size, -1.0, 1.0));
  const double middle = std::atan2(across, along);
  const double one = std::remainder(middle + spread, 2 * std::numbers::pi);
  const double other = std::remainder(middle - spread, 2 * std::numbers::pi);
  return std::abs(one) < std::abs(other) ? one : other;
}

/// Two bones in closed form: the knee gives the foot its distance, the hip its direction by the
/// shortest way. False, and nothing done, where the knee would jump: a leg that is almost straight
/// bends a lot for a millimetre.
bool solve_two_bones(Limb& limb, const Eigen::Vector3d& target) {
  const Eigen::Vector3d wanted = target - limb.center(0);
  const double bend = bend_for(limb, wanted.norm());
  if (std::abs(bend) > kLongestTurn) return false;
  limb.turn(3, bend);
  const Eigen::Vector3d reached = limb.position(0) - limb.center(0);
  if (reached.norm() > 0 && wanted.norm() > 0)
    limb.turn_ball(Eigen::Quaterniond::FromTwoVectors(reached, wanted).toRotationMatrix());
  return true;
}

/// Newton's method with the step that moves the limb least, damped. An angle is turned the more the
/// less its turning moves: an ankle that is off is not made good by the hip. From a start a few
/// centimetres off it ends within a fraction of the nearest pose in two or three steps. The damping
/// keeps a leg that is almost straight from jerking at the knee.
IkOutcome solve_nearest_pose(Limb& limb, Targets targets) {
  if (limb.is_two_bones() && miss(limb, targets) > kReachedCm &&
      solve_two_bones(limb, targets.front()))
    return {miss(limb, targets), 1};
  constexpr int kMostSteps = 12;
  constexpr double kDamping = 0.01;  // beside values of the normal matrix of about 1
  using Stacked = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3 * kMostEffectors, 1>;
  using Jacobian =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3 * kMostEffectors, kMostAngles>;
  using Normal = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3 * kMostEffectors,
                               3 * kMostEffectors>;
  using Angles = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostAngles, 1>;

  const auto rows = 3 * static_cast<Eigen::Index>(targets.size());
  IkOutcome outcome{miss(limb, targets)};
  Jacobian jacobian(rows, limb.angle_count());
  Stacked error(rows);
  Angles ease(limb.angle_count());
  for (int a = 0; a < limb.angle_count(); ++a) ease(a) = 1 / (1 + limb.disturbance(a));
  while (outcome.miss_cm > kReachedCm && outcome.iterations < kMostSteps) {
    for (Eigen::Index e = 0; e < std::ssize(targets); ++e) {
      error.segment<3>(3 * e) =
          targets[static_cast<std::size_t>(e)] - limb.position(static_cast<int>(e));
      for (int a = 0; a < limb.angle_count(); ++a)
        jacobian.block<3, 1>(3 * e, a) = limb.velocity(static_cast<int>(e), a);
    }
    Normal normal = jacobian * ease.asDiagonal() * jacobian.transpose();
    normal.diagonal().array() += kDamping;
    Angles step = ease.asDiagonal() * jacobian.transpose() * normal.ldlt().solve(error);
    const double longest = step.cwiseAbs().maxCoeff();
    if (longest > kLongestTurn) step *= kLongestTurn / longest;
    limb.turn(step);
    outcome.miss_cm = miss(limb, targets);
    ++outcome.iterations;
  }
  return outcome;
}

}  // namespace

std::string_view name(IkSolver solver) {
  return solver == IkSolver::CyclicDescent ? "cyclic-descent" : "nearest-pose";
}

IkOutcome solve(IkSolver solver, Limb& limb, Targets targets) {
  IkOutcome outcome = solver == IkSolver::CyclicDescent ? solve_cyclic_descent(limb, targets)
                                                        : solve_nearest_pose(limb, targets);
  outcome.reached = outcome.miss_cm <= kReachedCm;
  return outcome;
}

}  // namespace mocapress
