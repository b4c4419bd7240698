// SPDX-License-Identifier: MIT
#include "core/motion/rotation_form.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/parallel.h"
#include "core/motion/forward_kinematics.h"

namespace mocapress {
namespace {

constexpr std::array<std::array<int, 3>, kRotationOrders> kAxes = {
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// Axes of the joint's rotation channels, from the left.
std::vector<int> rotation_axes(const Joint& joint) {
  std::vector<int> axes;
  for (const ChannelKind kind : joint.channels)
    if (is_rotation(kind)) axes.push_back(axis_of(kind));
  return axes;
}

Joint with_form(Joint joint, const RotationForm& form) {
  std::size_t next = 0;
  for (ChannelKind& kind : joint.channels)
    if (is_rotation(kind)) kind = rotation_about(axes_of(form.order)[next++]);
  joint.before = rotation_of(form.before);
  joint.after = rotation_of(form.after);
  return joint;
}

/// The solution whose middle angle is within a right angle of zero, as in most sources.
Eigen::Vector3d first_angles(const std::array<int, 3>& axes, const Eigen::Matrix3d& rotation) {
  using std::numbers::pi;
  Eigen::Vector3d angles = three_angles(axes, rotation, Eigen::Vector3d::Zero());
  if (std::abs(angles(1)) <= pi / 2) return angles;
  const auto turned = [](double angle) { return std::remainder(angle + pi, 2 * pi); };
  return {turned(angles(0)), std::remainder(pi - angles(1), 2 * pi), turned(angles(2))};
}

/// Converts a joint's angles to another form, frame after frame.
class Conversion {
 public:
  Conversion(const Joint& joint, const RotationForm& form)
      : joint_(joint),
        axes_(axes_of(form.order)),
        left_(rotation_of(form.before).transpose() * joint.before),
        right_(joint.after * rotation_of(form.after).transpose()) {}

  Eigen::Vector3d next(const Eigen::RowVectorXd& values) {
    const Eigen::Matrix3d rotation = left_ * joint_rotation(joint_, values) * right_;
    last_ = last_ ? three_angles(axes_, rotation, *last_) : first_angles(axes_, rotation);
    return *last_;
  }
  void go_on_from(const Eigen::Vector3d& angles) { last_ = angles; }

 private:
  const Joint& joint_;
  std::array<int, 3> axes_;
  Eigen::Matrix3d left_;
  Eigen::Matrix3d right_;
  std::optional<Eigen::Vector3d> last_;
};

/// Places of a joint's rotation channels among all its channels.
std::vector<Eigen::Index> rotation_places(const Joint& joint) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < joint.channels.size(); ++i)
    if (is_rotation(joint.channels[i])) places.push_back(static_cast<Eigen::Index>(i));
  return places;
}

bool changes(const Joint& joint, const RotationForm& form) {
  return turns_freely(joint) &&
         (rotation_order(joint) != form.order || joint.before != rotation_of(form.before) ||
          joint.after != rotation_of(form.after));
}

auto channels_of(const Motion& motion, int joint) {
  return motion.clip.channels.middleCols(
      motion.skeleton.first_channel(joint),
      static_cast<Eigen::Index>(motion.skeleton.joint(joint).channels.size()));
}

Motion converted(const Motion& motion, const RotationForms& forms,
                 const Eigen::Matrix3Xd* first_angles) {
  Motion result{with_forms(motion.skeleton, forms), motion.clip};
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    if (!changes(joint, forms[j])) return;
    const auto from = channels_of(motion, j);
    auto to = result.clip.channels.middleCols(result.skeleton.first_channel(j), from.cols());
    const std::vector<Eigen::Index> places = rotation_places(joint);
    Conversion conversion(joint, forms[j]);
    if (first_angles) conversion.go_on_from(first_angles->col(j));
    for (Eigen::Index t = 0; t < from.rows(); ++t)
      to(t, places) = conversion.next(from.row(t)).transpose();
  });
  return result;
}

}  // namespace

std::array<int, 3> axes_of(RotationOrder order) {
  return kAxes[static_cast<std::size_t>(order)];
}

bool turns_freely(const Joint& joint) {
  std::vector<int> axes = rotation_axes(joint);
  std::ranges::sort(axes);
  return axes == std::vector{0, 1, 2};
}

RotationOrder rotation_order(const Joint& joint) {
  assert(turns_freely(joint));
  const std::vector<int> axes = rotation_axes(joint);
  const auto found = std::ranges::find_if(kAxes, [&](const std::array<int, 3>& of) {
    return std::equal(of.begin(), of.end(), axes.begin(), axes.end());
  });
  return static_cast<RotationOrder>(found - kAxes.begin());
}

Eigen::Matrix3d rotation_of(const FixedTurn& turn) {
  const Eigen::Vector3d vector =
      Eigen::Vector3d(turn[0], turn[1], turn[2]) * (std::numbers::pi / kFixedTurns);
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

FixedTurn fixed_turn_near(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd found(rotation);
  const Eigen::Vector3d vector = found.axis() * (found.angle() * kFixedTurns / std::numbers::pi);
  FixedTurn turn;
  for (int i = 0; i < 3; ++i)
    turn[i] = static_cast<std::int8_t>(
        std::clamp<long>(std::lround(vector(i)), -kFixedTurns, kFixedTurns - 1));
  return turn;
}

RotationForms rotation_forms(const Skeleton& skeleton) {
  RotationForms forms;
  for (const Joint& joint : skeleton.joints())
    forms.push_back({turns_freely(joint) ? rotation_order(joint) : RotationOrder::Xyz});
  return forms;
}

Skeleton with_forms(const Skeleton& skeleton, const RotationForms& forms) {
  assert(std::ssize(forms) == skeleton.joint_count());
  Skeleton result;
  for (std::size_t j = 0; j < forms.size(); ++j) {
    const Joint& joint = skeleton.joints()[j];
    result.add(turns_freely(joint) ? with_form(joint, forms[j]) : joint);
  }
  result.set_skin(skeleton.skin());  // still valid: the joints' rotations are the same
  return result;
}

Motion with_forms(const Motion& motion, const RotationForms& forms) {
  return converted(motion, forms, nullptr);
}

Motion with_forms(const Motion& motion, const RotationForms& forms,
                  const Eigen::Matrix3Xd& first_angles) {
  return converted(motion, forms, &first_angles);
}

std::vector<Eigen::Matrix3Xd> angles_at(const Motion& motion, const RotationForms& forms,
                                        const std::vector<int>& frames) {
  std::vector<Eigen::Matrix3Xd> angles(frames.size(),
                                       Eigen::Matrix3Xd::Zero(3, motion.skeleton.joint_count()));
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    if (!changes(joint, forms[j])) return;
    Conversion conversion(joint, forms[j]);
    int t = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (; t <= frames[i]; ++t) angles[i].col(j) = conversion.next(channels_of(motion, j).row(t));
  });
  return angles;
}

}  // namespace mocapress
