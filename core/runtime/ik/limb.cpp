// SPDX-License-Identifier: MIT
#include "core/runtime/ik/limb.h"

namespace mocapress::runtime {
Limb::Limb(Memory& memory, int most_links) {
  const auto links = static_cast<std::uint64_t>(most_links);
  places_ = memory.take<JointPlace>(links);
  values_ = memory.take<double>(kMostChannelsOfJoint * links);
  velocities_ =
      memory.take<double>(links > 0 ? std::uint64_t{kMostRows} * std::uint64_t{kMostAngles} : 0);
}

template <typename Real>
void Limb::set_frame(const Real* frame) {
  for (int l = 0; l < plan_.links; ++l) {
    const JointModel& joint = joints_[plan_.link[l].joint];
    for (int c = 0; c < joint.channels; ++c)
      values_[kMostChannelsOfJoint * l + c] = static_cast<double>(frame[joint.first_channel + c]);
  }
  for (int a = 0; a < plan_.turns; ++a)
    angles_[a] = static_cast<double>(frame[plan_.turn[a].channel]);
  update(0);
}

template void Limb::set_frame(const float*);
template void Limb::set_frame(const double*);

void Limb::turn(int angle, double by) {
  angles_[angle] += by;
  update(plan_.turn[angle].link);
}

void Limb::turn(const double* by) {
  for (int a = 0; a < plan_.turns; ++a) angles_[a] += by[a];
  update(first_turning_link());
}

void Limb::update(int first_link) {
  int turn = 0;  // first angle of the link, if it has any
  while (turn < plan_.turns && plan_.turn[turn].link < first_link) ++turn;
  for (int l = first_link; l < plan_.links; ++l) {
    const LimbLink& link = plan_.link[l];
    const JointModel& joint = joints_[link.joint];
    const bool may_turn = turn < plan_.turns && plan_.turn[turn].link == l;
    const JointPlace* const parent = link.parent < 0 ? nullptr : places_ + link.parent;
    Vector3 in_parent = joint.offset;
    Matrix3 world_from_axes = parent == nullptr ? Matrix3() : parent->world_from_joint;
    if (joint.has_axes) world_from_axes = world_from_axes * joint.parent_from_axes;
    for (int c = 0; c < joint.channels; ++c) {
      const int axis = axis_of(joint.kinds[c]);
      double value = values_[kMostChannelsOfJoint * l + c];
      if (!is_rotation(joint.kinds[c])) {
        in_parent[axis] += value;
        continue;
      }
      if (may_turn) {
        axes_[turn] = world_from_axes.column(axis);
        value = angles_[turn++];
      }
      turn_about(axis, value, world_from_axes);
    }
    JointPlace& place = places_[l];
    place.world_from_joint =
        joint.has_axes ? world_from_axes * joint.axes_from_joint : world_from_axes;
    place.origin =
        parent == nullptr ? in_parent : parent->origin + parent->world_from_joint * in_parent;
  }
}

Vector3 Limb::velocity(int effector, int angle) const {
  if (!moves(angle, effector)) return {};
  return cross(axis(angle), position(effector) - center(angle));
}

double Limb::disturbance(int angle) const {
  double sum = 0;
  for (int l = plan_.turn[angle].link + 1; l < plan_.links; ++l) {
    const Vector3 velocity = cross(axes_[angle], places_[l].origin - center(angle));
    sum += dot(velocity, velocity);
  }
  return sum / plan_.links;
}

void Limb::turn_ball(const Matrix3& rotation) {
  const LimbLink& ball = plan_.link[plan_.turn[0].link];
  const JointModel& joint = joints_[ball.joint];
  Matrix3 world_from_axes = ball.parent < 0 ? Matrix3() : places_[ball.parent].world_from_joint;
  if (joint.has_axes) world_from_axes = world_from_axes * joint.parent_from_axes;
  Matrix3 turned = transposed(world_from_axes) * (rotation * world_from_axes);
  const int axes[3] = {plan_.turn[0].axis, plan_.turn[1].axis, plan_.turn[2].axis};
  for (int i = 0; i < 3; ++i) turn_about(axes[i], angles_[i], turned);
  const Vector3 found = three_angles(axes, turned, Vector3{{angles_[0], angles_[1], angles_[2]}});
  for (int i = 0; i < 3; ++i) angles_[i] = found[i];
  update(first_turning_link());
}

}  // namespace mocapress::runtime
