// SPDX-License-Identifier: MIT
#include "resources/samples/generator/gait.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "resources/samples/generator/gait_steps.h"
#include "resources/samples/generator/leg_ik.h"
#include "resources/samples/generator/signal.h"
#include "resources/samples/generator/variation.h"

namespace mocapress::samples {
namespace {

constexpr double kMargin = 1.5;  // s planned before and after the clip

/// The movements of the rest of the body that follow from the feet.
class GaitBody {
 public:
  GaitBody(const Gait& gait, const Feet& feet, Random& random)
      : gait_(gait),
        path_(gait),
        left_swing_(random),
        right_swing_(random),
        feet_ahead_(sampled([&](double t) { return feet_ahead(feet, t); }).smoothed(0.10)),
        load_(sampled([&](double t) { return load(feet, t); }).smoothed(0.14)),
        sway_(sampled([&](double t) { return side_of_load(feet, t); }).smoothed(0.28)),
        height_(gait.centre_of == Centre::Mass ? bouncing_height(feet) : walking_height(feet)) {}

  Eigen::Vector3d centre(double seconds) const {
    return on_floor(seconds) + Eigen::Vector3d(0, height_.at(seconds), 0);
  }

  Posture posture(double seconds) const {
    Posture posture = trunk(seconds);
    add_arm(posture, Side::Left, seconds);
    add_arm(posture, Side::Right, seconds);
    return posture;
  }

 private:
  Signal sampled(const std::function<double(double)>& value) const {
    return Signal(-kMargin, gait_.seconds + kMargin, value);
  }

  double heading(double seconds) const { return path_.heading(path_.distance(seconds)); }

  /// The distance of the left ankle ahead of the right one, in steps.
  double feet_ahead(const Feet& feet, double seconds) const {
    const double angle = heading(seconds);
    const Eigen::Vector3d ahead(std::sin(angle), 0, std::cos(angle));
    const double step = gait_.speed * gait_.step_duration;
    return ahead.dot(feet.left.at(seconds).ankle - feet.right.at(seconds).ankle) / step;
  }

  /// 1: all weight on the left foot, -1: on the right one, 0: on both or none.
  static double load(const Feet& feet, double seconds) {
    return (feet.left.stance_at(seconds) ? 1 : 0) - (feet.right.stance_at(seconds) ? 1 : 0);
  }

  /// The mean distance of the loaded feet to the left of the path, in cm.
  double side_of_load(const Feet& feet, double seconds) const {
    const double angle = heading(seconds);
    const Eigen::Vector3d left(std::cos(angle), 0, -std::sin(angle));
    const Eigen::Vector3d middle = path_.place(path_.distance(seconds), 0);
    double sum = 0;
    int down = 0;
    for (const FootPlan* foot : {&feet.left, &feet.right})
      if (const Stance* stance = foot->stance_at(seconds)) {
        sum += left.dot(stance->print - middle);
        ++down;
      }
    return down > 0 ? sum / down : 0;
  }

  Eigen::Vector3d on_floor(double seconds) const {
    const double into_curve = -gait_.centre_height * std::tan(in_radians(bank(seconds)));
    return path_.place(path_.distance(seconds), gait_.sway * sway_.at(seconds) + into_curve);
  }

  /// As high as both legs let the root be, like an inverted pendulum, and no higher.
  Signal walking_height(const Feet& feet) const {
    constexpr double kStraightest = 7;    // degrees of knee flexion
    constexpr double kSmoothing = 0.075;  // s
    const double reach = leg_length(kStraightest);
    return sampled([&](double t) {
             const Posture posture = trunk(t);
             double height = gait_.centre_height;
             for (const Side side : {Side::Left, Side::Right}) {
               const Eigen::Vector3d hip =
                   on_floor(t) + world_from_root(posture) * mirrored_offset(side, kHipInRoot);
               const FootPlan& foot = side == Side::Left ? feet.left : feet.right;
               const Eigen::Vector3d leg = foot.at(t).ankle - hip;
               const double across = std::min(std::hypot(leg.x(), leg.z()), 0.9 * reach);
               height = std::min(height, leg.y() + std::sqrt(reach * reach - across * across));
             }
             return height;
           })
        .lowered(kSmoothing)
        .smoothed(kSmoothing);
  }

  /// The centre of mass falls freely between contacts; a contact throws it up for the next flight.
  Signal bouncing_height(const Feet& feet) const {
    std::vector<std::pair<double, double>> contacts;
    for (const FootPlan* foot : {&feet.left, &feet.right})
      for (const Stance& stance : foot->stances())
        contacts.emplace_back(stance.touchdown, stance.liftoff);
    std::ranges::sort(contacts);
    std::vector<BallisticTrack::Knot> knots;
    const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
    for (std::size_t i = 2; i + 1 < contacts.size(); ++i) {
      const double liftoff = contacts[i - 1].second;
      const double touchdown = contacts[i].first;
      const Eigen::Vector3d velocity = kGravity * (touchdown - liftoff) / 2 * up;
      knots.push_back({liftoff, gait_.centre_height * up, velocity, -kGravity * up});
      knots.push_back({touchdown, gait_.centre_height * up, -velocity, -kGravity * up});
    }
    const BallisticTrack track(std::move(knots));
    return sampled([&](double t) { return track.at(t).y(); });
  }

  Posture trunk(double seconds) const {
    const double ahead = feet_ahead_.at(seconds);
    const double load = load_.at(seconds);
    const double turn = -gait_.pelvis_turn * ahead;
    const double drop = gait_.pelvis_drop * load;
    const double chest = gait_.chest_turn * feet_ahead_.at(seconds - 0.03);
    const double nod = 1.5 * std::abs(feet_ahead_.at(seconds - 0.05));
    const double bank = this->bank(seconds);
    Posture posture;
    auto& degrees = posture.degrees;
    degrees["root"] = {0.35 * gait_.lean + nod, in_degrees(heading(seconds)) + turn, drop + bank};
    degrees["lowerback"] = {0.30 * gait_.lean - 0.5 * nod, 0.25 * chest, -0.40 * drop};
    degrees["upperback"] = {0.25 * gait_.lean, 0.35 * chest, -0.45 * drop};
    degrees["thorax"] = {0.10 * gait_.lean + 0.4 * nod, 0.40 * chest, -0.40 * drop};
    const double chest_in_path = turn + chest;
    degrees["lowerneck"] = {6 - 0.2 * gait_.lean, -0.25 * chest_in_path, 0.15 * drop};
    degrees["upperneck"] = {-3 - 0.3 * gait_.lean - 0.4 * nod, -0.30 * chest_in_path, -0.3 * bank};
    degrees["head"] = {-3 - 0.3 * gait_.lean - 0.5 * nod, -0.30 * chest_in_path, -0.3 * bank};
    return posture;
  }

  /// Into the curve, as far as the turn asks (degrees about the way ahead).
  double bank(double seconds) const {
    constexpr double kStep = 1e-3;  // s
    const double speed =
        (path_.distance(seconds + kStep) - path_.distance(seconds - kStep)) / (2 * kStep);
    return -in_degrees(std::atan(speed * speed * gait_.curvature / kGravity));
  }

  void add_arm(Posture& posture, Side side, double seconds) const {
    const bool is_left = side == Side::Left;
    const Drift& own = is_left ? left_swing_ : right_swing_;
    const double strength = (is_left ? 1.0 : 0.9) * (1 + 0.06 * own.at(seconds));
    // Each arm comes ahead with the other foot; what hangs further out follows later.
    const auto ahead = [&](double lag) {
      return (is_left ? -strength : strength) * feet_ahead_.at(seconds - lag);
    };
    const double swing = ahead(0.04);
    const double forward = std::max(0.0, swing) * std::max(0.0, swing);
    const double lagging = ahead(0.09);
    posture.set(side, "clavicle", {0, -1 - 3 * ahead(0.02), 1.5 + 0.8 * std::abs(swing)});
    posture.set(side, "humerus",
                {2 - gait_.arm_swing * swing, -12 - gait_.inward * forward, gait_.abduction});
    posture.set(side, "radius", {-gait_.elbow - gait_.elbow_swing * ahead(0.07), 0, 0});
    posture.set(side, "wrist", {0, -28 - 8 * lagging, 0});
    posture.set(side, "hand", {7 - 4 * lagging, 0, 3 * ahead(0.11)});
    posture.set(side, "fingers", {gait_.finger_curl + 3 * ahead(0.10), 0, 0});
    posture.set(side, "thumb", {12 + 2 * ahead(0.10), 0, 14 - 3 * lagging});
  }

  Gait gait_;
  GaitPath path_;
  Drift left_swing_;
  Drift right_swing_;
  Signal feet_ahead_;
  Signal load_;
  Signal sway_;
  Signal height_;
};

}  // namespace

Choreography choreograph(const Gait& gait, std::uint64_t seed) {
  Random random(seed);
  const Feet feet = plan_steps(gait, random);
  const auto body = std::make_shared<const GaitBody>(gait, feet, random);
  return {gait.seconds,
          feet.left,
          feet.right,
          gait.centre_of,
          [body](double seconds) { return body->centre(seconds); },
          [body](double seconds) { return body->posture(seconds); }};
}

}  // namespace mocapress::samples
