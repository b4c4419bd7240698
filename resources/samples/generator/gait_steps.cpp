// SPDX-License-Identifier: MIT
#include "resources/samples/generator/gait_steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "resources/samples/generator/curves.h"
#include "resources/samples/generator/human_skeleton.h"
#include "resources/samples/generator/variation.h"

namespace mocapress::samples {
namespace {

constexpr double kTimeJitter = 0.008;  // s
constexpr double kPrintJitter = 1.2;   // cm, along the way; half of it across
constexpr double kAngleJitter = 2.0;   // degrees
constexpr double kStandingBehind = 4;  // cm, of the ankles behind the body
constexpr double kLongStanding = 100;  // s, before the first step and after the last

/// The integral of eased() from 0 to (seconds - start) / duration, in seconds.
double eased_seconds(double seconds, double start, double duration) {
  const double s = std::clamp((seconds - start) / duration, 0.0, 1.0);
  const double ramp = s * s * s * s * (2.5 + s * (s - 3));
  return duration * ramp + std::max(0.0, seconds - start - duration);
}

/// One side's contacts, as places along the path.
class StepPlanner {
 public:
  StepPlanner(const Gait& gait, Side side, Random& random)
      : gait_(gait), path_(gait), sign_(side == Side::Left ? 1 : -1), random_(random) {
    stand_until_first_step(side);
    for (int step = side == Side::Right ? 0 : 1; step < gait.steps; step += 2) add_step(step);
    stances_.back().liftoff = kLongStanding;
    place_prints();
  }

  FootPlan plan() const {
    std::vector<std::vector<Waypoint>> swings;
    for (std::size_t i = 0; i + 1 < stances_.size(); ++i) swings.push_back(swing(i));
    return FootPlan(stances_, swings);
  }

 private:
  void stand_until_first_step(Side side) {
    Stance stance = next_stance();
    stance.touchdown = -kLongStanding;
    stance.liftoff = gait_.first_liftoff + (side == Side::Left ? gait_.step_duration : 0);
    stances_.push_back(stance);
  }

  void add_step(int step) {
    const double liftoff = gait_.first_liftoff + step * gait_.step_duration;
    Stance stance = next_stance();
    stances_.back().liftoff = liftoff + kTimeJitter * jitter(random_);
    stance.touchdown = liftoff + gait_.swing_duration + kTimeJitter * jitter(random_);
    stances_.push_back(stance);
  }

  Stance next_stance() {
    const auto varied = [&](double degrees) {
      return in_radians(degrees + kAngleJitter * jitter(random_));
    };
    Stance stance{};
    stance.touchdown_pitch = varied(gait_.touchdown_pitch);
    stance.liftoff_pitch = varied(gait_.liftoff_pitch);
    stance.liftoff_toe_pitch = varied(gait_.liftoff_toe_pitch);
    stance.yaw = sign_ * varied(gait_.toe_out);
    stance.settling = gait_.settling;
    stance.heel_rise = gait_.heel_rise;
    stance.toe_rise = gait_.toe_rise;
    return stance;
  }

  void place_prints() {
    for (std::size_t i = 0; i < stances_.size(); ++i) {
      Stance& stance = stances_[i];
      const bool standing = i == 0 || i + 1 == stances_.size();
      const double middle = (stance.touchdown + stance.liftoff) / 2;
      double distance = path_.distance(i == 0 ? -kLongStanding : standing ? kLongStanding : middle);
      distance +=
          kPrintJitter * jitter(random_) - (standing ? kStandingBehind : gait_.print_behind);
      const double width = standing ? gait_.half_standing_width : gait_.half_step_width;
      const double left = sign_ * width + kPrintJitter / 2 * jitter(random_);
      stance.print = path_.place(distance, left);
      stance.yaw += path_.heading(distance);
      distances_.push_back(distance);
      lefts_.push_back(left);
    }
    for (std::size_t i = 0; i + 1 < stances_.size(); ++i) {
      const double effort = this->effort(i);
      stances_[i].liftoff_pitch *= effort;
      stances_[i].liftoff_toe_pitch *= effort;
      stances_[i + 1].touchdown_pitch *= effort;
    }
  }

  /// The length of the swing after stance i as a share of a full stride.
  double effort(std::size_t i) const {
    const double stride = 2 * gait_.step_duration * gait_.speed;
    return std::clamp((distances_[i + 1] - distances_[i]) / stride, 0.3, 1.0);
  }

  std::vector<Waypoint> swing(std::size_t i) const {
    const Stance& from = stances_[i];
    const Stance& to = stances_[i + 1];
    const double effort = this->effort(i);
    const double behind = distances_[i] - path_.distance(from.liftoff);
    const double ahead = distances_[i + 1] - path_.distance(to.touchdown);
    std::vector<Waypoint> waypoints;
    for (const Gait::SwingPoint& point : gait_.swing) {
      const double seconds = std::lerp(from.liftoff, to.touchdown, point.share);
      const double distance = path_.distance(seconds) + std::lerp(behind, ahead, point.way);
      const double left =
          std::lerp(lefts_[i], lefts_[i + 1], point.share) + sign_ * gait_.swing_out * effort;
      // The toes have to clear the floor in a short step too.
      const Eigen::Vector3d up(0, kAnkleHeight + point.height * (1 + effort) / 2, 0);
      waypoints.push_back(
          {seconds,
           {path_.place(distance, left) + up, std::lerp(from.yaw, to.yaw, point.share),
            in_radians(point.pitch * effort), in_radians(point.toe_pitch * effort)}});
    }
    return waypoints;
  }

  const Gait& gait_;
  GaitPath path_;
  double sign_;
  Random& random_;
  std::vector<Stance> stances_;
  std::vector<double> distances_;  // cm, of each print along the path
  std::vector<double> lefts_;      // cm, of each print across it
};

}  // namespace

double GaitPath::distance(double seconds) const {
  return gait_.speed * (eased_seconds(seconds, gait_.start, gait_.start_duration) -
                        eased_seconds(seconds, gait_.stop, gait_.stop_duration));
}

double GaitPath::heading(double distance) const {
  return gait_.curvature * (distance - gait_.arc_middle);
}

Eigen::Vector3d GaitPath::place(double distance, double left) const {
  const double angle = heading(distance);
  const double radius = 1 / gait_.curvature;
  return {radius * (1 - std::cos(angle)) + left * std::cos(angle), 0,
          radius * std::sin(angle) - left * std::sin(angle)};
}

Feet plan_steps(const Gait& gait, Random& random) {
  FootPlan left = StepPlanner(gait, Side::Left, random).plan();
  FootPlan right = StepPlanner(gait, Side::Right, random).plan();
  return {std::move(left), std::move(right)};
}

}  // namespace mocapress::samples
