// SPDX-License-Identifier: MIT
#include "resources/samples/generator/foot_plan.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/motion/skeleton.h"
#include "resources/samples/generator/human_skeleton.h"

namespace mocapress::samples {
namespace {

using Row = Eigen::Matrix<double, 1, 6>;

Row row_of(const FootState& foot) {
  Row row;
  row << foot.ankle.transpose(), foot.yaw, foot.pitch, foot.toe_pitch;
  return row;
}

FootState state_of(const Row& row) {
  return {row.head<3>().transpose(), row(3), row(4), row(5)};
}

ClampedSpline swing_between(const Stance& from, const Stance& to,
                            const std::vector<Waypoint>& waypoints) {
  constexpr double kStep = 1e-4;  // s
  const auto count = static_cast<Eigen::Index>(waypoints.size()) + 2;
  std::vector<double> seconds = {from.liftoff};
  Eigen::MatrixXd values(count, 6);
  values.row(0) = row_of(from.at(from.liftoff));
  for (const Waypoint& waypoint : waypoints) {
    values.row(static_cast<Eigen::Index>(seconds.size())) = row_of(waypoint.foot);
    seconds.push_back(waypoint.seconds);
  }
  seconds.push_back(to.touchdown);
  values.row(count - 1) = row_of(to.at(to.touchdown));
  const Row leaving = (values.row(0) - row_of(from.at(from.liftoff - kStep))) / kStep;
  const Row landing = (row_of(to.at(to.touchdown + kStep)) - values.row(count - 1)) / kStep;
  return ClampedSpline(std::move(seconds), std::move(values), leaving, landing);
}

}  // namespace

Eigen::Matrix3d FootState::world_from_foot() const {
  return axis_rotation(1, yaw) * axis_rotation(0, pitch);
}

Eigen::Matrix3d FootState::world_from_toes() const {
  return axis_rotation(1, yaw) * axis_rotation(0, toe_pitch);
}

Eigen::Vector3d FootState::heel() const {
  return ankle + world_from_foot() * kHeelInFoot;
}

Eigen::Vector3d FootState::ball() const {
  return ankle + world_from_foot() * kBallJointInFoot + world_from_toes() * kBallInToes;
}

Eigen::Vector3d FootState::tip() const {
  return ankle + world_from_foot() * kBallJointInFoot + world_from_toes() * kTipInToes;
}

FootState Stance::at(double seconds) const {
  FootState foot{print + Eigen::Vector3d(0, kAnkleHeight, 0), yaw, 0, 0};
  const Eigen::Vector3d heel_print = foot.heel();
  const Eigen::Vector3d tip_print = foot.tip();
  const double unsettled = std::clamp((touchdown + settling - seconds) / settling, 0.0, 1.0);
  const double risen = std::clamp((seconds - liftoff + heel_rise) / heel_rise, 0.0, 1.0);
  const double toes_risen = std::clamp((seconds - liftoff + toe_rise) / toe_rise, 0.0, 1.0);
  foot.pitch = touchdown_pitch * unsettled * unsettled + liftoff_pitch * risen * risen;
  foot.toe_pitch = foot.pitch < 0 ? foot.pitch : liftoff_toe_pitch * toes_risen * toes_risen;
  foot.ankle += foot.pitch < 0 ? heel_print - foot.heel() : tip_print - foot.tip();
  return foot;
}

bool Stance::heel_down(double seconds) const {
  const double from = touchdown_pitch > 0 ? touchdown + settling : touchdown;
  return seconds >= from && seconds <= liftoff - heel_rise;
}

bool Stance::ball_down(double seconds) const {
  const double from = touchdown_pitch < 0 ? touchdown + settling : touchdown;
  return seconds >= from && seconds <= liftoff - toe_rise;
}

FootPlan::FootPlan(std::vector<Stance> stances, const std::vector<std::vector<Waypoint>>& swings)
    : stances_(std::move(stances)) {
  assert(swings.size() + 1 == stances_.size());
  for (std::size_t i = 0; i < swings.size(); ++i)
    swings_.push_back(swing_between(stances_[i], stances_[i + 1], swings[i]));
}

const Stance* FootPlan::stance_at(double seconds) const {
  for (const Stance& stance : stances_)
    if (seconds >= stance.touchdown && seconds <= stance.liftoff) return &stance;
  return nullptr;
}

FootState FootPlan::at(double seconds) const {
  if (seconds < stances_.front().touchdown) return stances_.front().at(seconds);
  if (const Stance* stance = stance_at(seconds)) return stance->at(seconds);
  for (std::size_t i = 0; i < swings_.size(); ++i)
    if (seconds < stances_[i + 1].touchdown) return state_of(swings_[i].at(seconds));
  return stances_.back().at(seconds);
}

}  // namespace mocapress::samples
