// SPDX-License-Identifier: MIT
#include "core/motion/rotation_order.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/parallel.h"
#include "core/motion/joint_rotation.h"

namespace mocapress {
namespace {

constexpr std::array<std::array<int, 3>, kRotationOrders> kAxes = {
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

/// Of the joint's rotation channels, from the left.
std::vector<int> rotation_axes(const Joint& joint) {
  std::vector<int> axes;
  for (const ChannelKind kind : joint.channels)
    if (is_rotation(kind)) axes.push_back(axis_of(kind));
  return axes;
}

Joint with_order(Joint joint, RotationOrder order) {
  std::size_t next = 0;
  for (ChannelKind& kind : joint.channels)
    if (is_rotation(kind)) kind = rotation_about(axes_of(order)[next++]);
  return joint;
}

/// Of both solutions the one whose middle angle is within a right one, as most sources have it.
Eigen::Vector3d first_angles(const std::array<int, 3>& axes, const Eigen::Matrix3d& rotation) {
  using std::numbers::pi;
  const Eigen::Vector3d angles = three_angles(axes, rotation, Eigen::Vector3d::Zero());
  if (std::abs(angles(1)) <= pi / 2) return angles;
  const auto turned = [](double angle) { return std::remainder(angle + pi, 2 * pi); };
  return {turned(angles(0)), std::remainder(pi - angles(1), 2 * pi), turned(angles(2))};
}

/// A joint's angles in another order, frame after frame.
class Conversion {
 public:
  Conversion(const Joint& joint, RotationOrder order) : joint_(joint), axes_(axes_of(order)) {}

  Eigen::Vector3d next(const Eigen::RowVectorXd& values) {
    const Eigen::Matrix3d rotation = joint_rotation(joint_, values);
    last_ = last_ ? three_angles(axes_, rotation, *last_) : first_angles(axes_, rotation);
    return *last_;
  }
  void go_on_from(const Eigen::Vector3d& angles) { last_ = angles; }

 private:
  const Joint& joint_;
  std::array<int, 3> axes_;
  std::optional<Eigen::Vector3d> last_;
};

/// Where a joint's rotation channels are among its channels.
std::vector<Eigen::Index> rotation_places(const Joint& joint) {
  std::vector<Eigen::Index> places;
  for (std::size_t i = 0; i < joint.channels.size(); ++i)
    if (is_rotation(joint.channels[i])) places.push_back(static_cast<Eigen::Index>(i));
  return places;
}

bool changes(const Joint& joint, RotationOrder order) {
  return turns_freely(joint) && rotation_order(joint) != order;
}

auto channels_of(const Motion& motion, int joint) {
  return motion.clip.channels.middleCols(
      motion.skeleton.first_channel(joint),
      static_cast<Eigen::Index>(motion.skeleton.joint(joint).channels.size()));
}

Motion converted(const Motion& motion, const RotationOrders& orders,
                 const Eigen::Matrix3Xd* first_angles) {
  Motion result{with_orders(motion.skeleton, orders), motion.clip};
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    if (!changes(joint, orders[static_cast<std::size_t>(j)])) return;
    const auto from = channels_of(motion, j);
    auto to = result.clip.channels.middleCols(result.skeleton.first_channel(j), from.cols());
    const std::vector<Eigen::Index> places = rotation_places(joint);
    Conversion conversion(joint, orders[static_cast<std::size_t>(j)]);
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
  std::sort(axes.begin(), axes.end());
  return axes == std::vector{0, 1, 2};
}

RotationOrder rotation_order(const Joint& joint) {
  assert(turns_freely(joint));
  const std::vector<int> axes = rotation_axes(joint);
  const auto found = std::find_if(kAxes.begin(), kAxes.end(), [&](const std::array<int, 3>& of) {
    return std::equal(of.begin(), of.end(), axes.begin(), axes.end());
  });
  return static_cast<RotationOrder>(found - kAxes.begin());
}

RotationOrders rotation_orders(const Skeleton& skeleton) {
  RotationOrders orders;
  for (const Joint& joint : skeleton.joints())
    orders.push_back(turns_freely(joint) ? rotation_order(joint) : RotationOrder::Xyz);
  return orders;
}

Skeleton with_orders(const Skeleton& skeleton, const RotationOrders& orders) {
  assert(std::ssize(orders) == skeleton.joint_count());
  Skeleton result;
  for (std::size_t j = 0; j < orders.size(); ++j) {
    const Joint& joint = skeleton.joints()[j];
    result.add(turns_freely(joint) ? with_order(joint, orders[j]) : joint);
  }
  return result;
}

Motion with_orders(const Motion& motion, const RotationOrders& orders) {
  return converted(motion, orders, nullptr);
}

Motion with_orders(const Motion& motion, const RotationOrders& orders,
                   const Eigen::Matrix3Xd& first_angles) {
  return converted(motion, orders, &first_angles);
}

std::vector<Eigen::Matrix3Xd> angles_at(const Motion& motion, const RotationOrders& orders,
                                        const std::vector<int>& frames) {
  std::vector<Eigen::Matrix3Xd> angles(frames.size(),
                                       Eigen::Matrix3Xd::Zero(3, motion.skeleton.joint_count()));
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    if (!changes(joint, orders[static_cast<std::size_t>(j)])) return;
    Conversion conversion(joint, orders[static_cast<std::size_t>(j)]);
    int t = 0;
    for (std::size_t i = 0; i < frames.size(); ++i)
      for (; t <= frames[i]; ++t) angles[i].col(j) = conversion.next(channels_of(motion, j).row(t));
  });
  return angles;
}

}  // namespace mocapress
