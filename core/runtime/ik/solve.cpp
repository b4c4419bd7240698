// SPDX-License-Identifier: MIT
// Based on: C. Welman, "Inverse kinematics and geometric constraints for articulated figure
// manipulation", 1993 (cyclic coordinate descent), and S. R. Buss, "Introduction to inverse
// kinematics with Jacobian transpose, pseudoinverse and damped least squares methods", 2004.
#include "core/runtime/ik/solve.h"

#include <algorithm>
#include <cmath>

#include "core/runtime/format/trigonometry.h"

namespace mocapress::runtime {
namespace {

double miss(const Limb& limb, const Vector3* targets) {
  double largest = 0;
  for (int e = 0; e < limb.plan().effectors; ++e)
    largest = std::max(largest, norm(targets[e] - limb.position(e)));
  return largest;
}

/// The rotation about an angle's axis that minimises the sum of the squared distances between the
/// effectors and their targets.
double best_turn(const Limb& limb, int angle, const Vector3* targets) {
  const Vector3& axis = limb.axis(angle);
  double along = 0;   // sum of the targets' components along the effectors' arms
  double across = 0;  // the same across the arms, in the direction of rotation
  for (int e = 0; e < limb.plan().effectors; ++e) {
    if (!limb.moves(angle, e)) continue;
    const Vector3 arm = limb.position(e) - limb.center(angle);
    const Vector3 wanted = targets[e] - limb.center(angle);
    along += dot(arm, wanted) - dot(axis, arm) * dot(axis, wanted);
    across += dot(axis, cross(arm, wanted));
  }
  return along == 0 && across == 0 ? 0 : arc_tangent(across, along);
}

SolveOutcome solve_cyclic_descent(Limb& limb, const Vector3* targets, int most_sweeps) {
  SolveOutcome outcome{miss(limb, targets)};
  while (outcome.miss_cm > kReachedCm && outcome.iterations < most_sweeps) {
    for (int a = limb.plan().turns - 1; a >= 0; --a) limb.turn(a, best_turn(limb, a, targets));
    outcome.miss_cm = miss(limb, targets);
    ++outcome.iterations;
  }
  return outcome;
}

constexpr double kLongestTurn = 0.35;  // radians per step; beyond that, the linear approximation is
                                       // poor

/// The rotation of the knee that brings the foot to the distance `reach` from the hip; the smaller
/// of the two solutions. If the leg is too short, the knee is straightened as far as the hinge
/// allows.
double bend_for(const Limb& limb, double reach) {
  constexpr int kKnee = 3;
  const Vector3 thigh = limb.center(kKnee) - limb.center(0);
  const Vector3 shin = limb.position(0) - limb.center(kKnee);
  const Vector3& axis = limb.axis(kKnee);
  // The squared distance |thigh + shin rotated by t|^2 is a constant + 2 (along cos t + across sin
  // t).
  const double fixed = dot(axis, shin) * dot(axis, thigh);
  const double along = dot(thigh, shin) - fixed;
  const double across = dot(thigh, cross(axis, shin));
  const double size = std::sqrt(along * along + across * across);
  if (!(size > 0)) return 0;
  const double wanted = (reach * reach - dot(thigh, thigh) - dot(shin, shin)) / 2 - fixed;
  const double spread = arc_cosine(std::clamp(wanted / size, -1.0, 1.0));
  const double middle = arc_tangent(across, along);
  const double one = std::remainder(middle + spread, 2 * kPi);
  const double other = std::remainder(middle - spread, 2 * kPi);
  return std::abs(one) < std::abs(other) ? one : other;
}

/// The shortest rotation that takes the direction of `from` to that of `to`. Neither may be zero.
Matrix3 rotation_between(const Vector3& from, const Vector3& to) {
  const double length_of_from = norm(from);
  const double length_of_to = norm(to);
  Vector3 a;
  Vector3 b;
  for (int i = 0; i < 3; ++i) {
    a[i] = from[i] / length_of_from;
    b[i] = to[i] / length_of_to;
  }
  const double cosine = dot(a, b);
  Vector3 axis = cross(a, b);
  double w = 1 + cosine;
  if (w < 1e-12) {
    // Half a turn may be about any axis perpendicular to `from`.
    const int least = std::abs(a[0]) < std::abs(a[1]) ? (std::abs(a[0]) < std::abs(a[2]) ? 0 : 2)
                                                      : (std::abs(a[1]) < std::abs(a[2]) ? 1 : 2);
    Vector3 other;
    other[least] = 1;
    axis = cross(a, other);
    w = 0;
  }
  const double size = std::sqrt(w * w + dot(axis, axis));
  return rotation_of(w / size, axis[0] / size, axis[1] / size, axis[2] / size);
}

/// Solves two bones in closed form: the knee sets the distance of the foot, then the hip its
/// direction. Returns false, without changes, if the knee would turn by more than kLongestTurn: an
/// almost straight leg bends a lot for a millimetre.
bool solve_two_bones(Limb& limb, const Vector3& target) {
  const Vector3 wanted = target - limb.center(0);
  const double bend = bend_for(limb, norm(wanted));
  if (!(std::abs(bend) <= kLongestTurn)) return false;
  limb.turn(3, bend);
  const Vector3 reached = limb.position(0) - limb.center(0);
  if (norm(reached) > 0 && norm(wanted) > 0) limb.turn_ball(rotation_between(reached, wanted));
  return true;
}

/// The matrix of the normal equations of a damped least-squares step.
class Normal {
 public:
  explicit Normal(int rows) : rows_(rows) {}

  double& at(int i, int j) { return matrix_[i][j]; }

  /// Solves matrix * x = b in place, by Cholesky's L D L^T. The matrix must be symmetric and
  /// positive definite; only its lower half is read.
  void solve(double* b) {
    for (int j = 0; j < rows_; ++j)
      for (int i = j; i < rows_; ++i) {
        double sum = matrix_[i][j];
        for (int k = 0; k < j; ++k) sum -= matrix_[i][k] * matrix_[j][k] * matrix_[k][k];
        matrix_[i][j] = i == j ? sum : sum / matrix_[j][j];
      }
    for (int i = 0; i < rows_; ++i)
      for (int k = 0; k < i; ++k) b[i] -= matrix_[i][k] * b[k];
    for (int i = rows_ - 1; i >= 0; --i) {
      b[i] /= matrix_[i][i];
      for (int k = i + 1; k < rows_; ++k) b[i] -= matrix_[k][i] * b[k];
    }
  }

 private:
  int rows_;
  double matrix_[kMostRows][kMostRows];
};

/// Takes one damped Newton step: of all steps, the one that moves the limb least. `ease` has a
/// weight per angle; an angle with a larger weight turns more.
void step_to(Limb& limb, const Vector3* targets, const double* ease) {
  constexpr double kDamping = 0.01;  // added to the diagonal, whose values are about 1
  const int angles = limb.plan().turns;
  const int rows = 3 * limb.plan().effectors;
  const auto jacobian = reinterpret_cast<double(*)[kMostAngles]>(limb.velocities());
  double error[kMostRows];
  for (int e = 0; e < limb.plan().effectors; ++e) {
    const Vector3 lacking = targets[e] - limb.position(e);
    for (int i = 0; i < 3; ++i) error[3 * e + i] = lacking[i];
    for (int a = 0; a < angles; ++a) {
      const Vector3 velocity = limb.velocity(e, a);
      for (int i = 0; i < 3; ++i) jacobian[3 * e + i][a] = velocity[i];
    }
  }
  Normal normal(rows);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = i == j ? kDamping : 0;
      for (int a = 0; a < angles; ++a) sum += jacobian[i][a] * ease[a] * jacobian[j][a];
      normal.at(i, j) = sum;
    }
  normal.solve(error);
  double step[kMostAngles] = {};
  double longest = 0;
  for (int a = 0; a < angles; ++a) {
    for (int i = 0; i < rows; ++i) step[a] += jacobian[i][a] * error[i];
    step[a] *= ease[a];
    longest = std::max(longest, std::abs(step[a]));
  }
  if (longest > kLongestTurn)
    for (int a = 0; a < angles; ++a) step[a] *= kLongestTurn / longest;
  limb.turn(step);
}

/// Solves by damped Newton steps; two bones in closed form. Angles that move less of the limb turn
/// more, so that an error of the ankle is not corrected at the hip. From a few centimetres away,
/// two or three steps come close to the nearest pose. The damping keeps an almost straight leg from
/// jerking at the knee.
SolveOutcome solve_nearest_pose(Limb& limb, const Vector3* targets, int most_steps) {
  SolveOutcome outcome{miss(limb, targets)};
  if (!(outcome.miss_cm > kReachedCm) || most_steps == 0) return outcome;
  if (limb.plan().is_two_bones && solve_two_bones(limb, targets[0]))
    return {miss(limb, targets), 1};
  double ease[kMostAngles];
  for (int a = 0; a < limb.plan().turns; ++a) ease[a] = 1 / (1 + limb.disturbance(a));
  while (outcome.miss_cm > kReachedCm && outcome.iterations < most_steps) {
    step_to(limb, targets, ease);
    outcome.miss_cm = miss(limb, targets);
    ++outcome.iterations;
  }
  return outcome;
}

}  // namespace

SolveOutcome solve(Solver solver, Limb& limb, const Vector3* targets, int most_iterations) {
  return solver == Solver::CyclicDescent
             ? solve_cyclic_descent(limb, targets, std::min(most_iterations, kMostSweeps))
             : solve_nearest_pose(limb, targets, std::min(most_iterations, kMostNewtonSteps));
}

}  // namespace mocapress::runtime
