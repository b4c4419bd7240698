// SPDX-License-Identifier: MIT
#include "core/ik/limb.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

#include "core/base/error.h"
#include "core/motion/joint_rotation.h"

namespace mocapress {

Limb::Limb(const Skeleton& skeleton, std::vector<Effector> effectors)
    : effectors_(std::move(effectors)),
      turn_of_channel_(static_cast<std::size_t>(skeleton.channel_count()), -1),
      frame_(Eigen::RowVectorXd::Zero(skeleton.channel_count())) {
  std::set<int> joints;
  std::set<int> turning;
  for (const Effector& effector : effectors_) {
    for (int j = effector.joint; j >= 0; j = skeleton.joint(j).parent) joints.insert(j);
    turning.insert(effector.chain.begin(), effector.chain.end());
  }
  for (const int j : joints) {
    const Joint& joint = skeleton.joint(j);
    const int parent = joint.parent < 0 ? -1 : link_of(joint.parent);
    links_.push_back({&joint, j, parent, skeleton.first_channel(j)});
    if (!turning.contains(j)) continue;
    for (std::size_t i = 0; i < joint.channels.size(); ++i) {
      if (!is_rotation(joint.channels[i])) continue;
      const int channel = skeleton.first_channel(j) + static_cast<int>(i);
      turn_of_channel_[static_cast<std::size_t>(channel)] = static_cast<int>(turns_.size());
      turns_.push_back({channel, static_cast<int>(links_.size()) - 1, axis_of(joint.channels[i])});
    }
  }
  for (const Effector& effector : effectors_) {
    effector_links_.push_back(link_of(effector.joint));
    for (const Turn& turn : turns_) {
      const int joint = links_[static_cast<std::size_t>(turn.link)].joint_index;
      moves_.push_back(std::find(effector.chain.begin(), effector.chain.end(), joint) !=
                       effector.chain.end());
    }
  }
  angles_.setZero(std::ssize(turns_));
  if (!turns_.empty()) first_turning_link_ = turns_.front().link;
  is_two_bones_ = find_two_bones();
}

bool Limb::find_two_bones() const {
  if (effectors_.size() != 1 || turns_.size() != 4) return false;
  return turns_[0].link == turns_[2].link && turns_[3].link != turns_[2].link &&
         turns_[0].axis != turns_[1].axis && turns_[1].axis != turns_[2].axis &&
         turns_[0].axis != turns_[2].axis;
}

void Limb::turn_ball(const Eigen::Matrix3d& rotation) {
  const Link& ball = links_[static_cast<std::size_t>(turns_[0].link)];
  Eigen::Matrix3d world_from_axes = ball.joint->joint_from_axes;
  if (ball.parent >= 0)
    world_from_axes =
        links_[static_cast<std::size_t>(ball.parent)].world_from_joint * world_from_axes;
  const std::array<int, 3> axes = {turns_[0].axis, turns_[1].axis, turns_[2].axis};
  Eigen::Matrix3d turned = world_from_axes.transpose() * rotation * world_from_axes;
  for (std::size_t i = 0; i < 3; ++i)
    turned *= axis_rotation(axes[i], angles_(static_cast<Eigen::Index>(i)));
  angles_.head<3>() = three_angles(axes, turned, angles_.head<3>());
  update(first_turning_link_);
}

int Limb::link_of(int joint) const {
  const auto link = std::find_if(links_.begin(), links_.end(), [&](const Link& candidate) {
    return candidate.joint_index == joint;
  });
  return static_cast<int>(link - links_.begin());
}

void Limb::set_frame(const FrameRow& frame) {
  frame_ = frame;
  for (int a = 0; a < angle_count(); ++a) angles_(a) = frame(channel(a));
  update(0);
}

void Limb::turn(int angle, double by) {
  angles_(angle) += by;
  update(turns_[static_cast<std::size_t>(angle)].link);
}

void Limb::turn(const Eigen::Ref<const Eigen::VectorXd>& by) {
  angles_ += by;
  update(first_turning_link_);
}

void Limb::update(int first_link) {
  for (auto l = static_cast<std::size_t>(first_link); l < links_.size(); ++l) {
    Link& link = links_[l];
    const Link* parent = link.parent < 0 ? nullptr : &links_[static_cast<std::size_t>(link.parent)];
    Eigen::Vector3d in_parent = link.joint->offset;
    Eigen::Matrix3d world_from_axes = link.joint->joint_from_axes;
    if (parent != nullptr) world_from_axes = parent->world_from_joint * world_from_axes;
    for (std::size_t i = 0; i < link.joint->channels.size(); ++i) {
      const ChannelKind kind = link.joint->channels[i];
      const int channel = link.first_channel + static_cast<int>(i);
      const int turn = turn_of_channel_[static_cast<std::size_t>(channel)];
      if (!is_rotation(kind)) {
        in_parent(axis_of(kind)) += frame_(channel);
        continue;
      }
      if (turn >= 0)
        turns_[static_cast<std::size_t>(turn)].axis_in_world = world_from_axes.col(axis_of(kind));
      world_from_axes *= axis_rotation(axis_of(kind), turn >= 0 ? angles_(turn) : frame_(channel));
    }
    link.world_from_joint = world_from_axes * link.joint->joint_from_axes.transpose();
    link.origin_in_world = in_parent;
    if (parent != nullptr)
      link.origin_in_world = parent->origin_in_world + parent->world_from_joint * in_parent;
  }
}

const Eigen::Vector3d& Limb::position(int effector) const {
  const int link = effector_links_[static_cast<std::size_t>(effector)];
  return links_[static_cast<std::size_t>(link)].origin_in_world;
}

const Eigen::Vector3d& Limb::center(int angle) const {
  const int link = turns_[static_cast<std::size_t>(angle)].link;
  return links_[static_cast<std::size_t>(link)].origin_in_world;
}

bool Limb::moves(int angle, int effector) const {
  return moves_[static_cast<std::size_t>(effector) * turns_.size() +
                static_cast<std::size_t>(angle)];
}

Eigen::Vector3d Limb::velocity(int effector, int angle) const {
  if (!moves(angle, effector)) return Eigen::Vector3d::Zero();
  return axis(angle).cross(position(effector) - center(angle));
}

double Limb::disturbance(int angle) const {
  const Turn& turn = turns_[static_cast<std::size_t>(angle)];
  double sum = 0;
  for (std::size_t l = static_cast<std::size_t>(turn.link) + 1; l < links_.size(); ++l)
    sum += turn.axis_in_world.cross(links_[l].origin_in_world - center(angle)).squaredNorm();
  return sum / static_cast<double>(links_.size());
}

std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<Effector>& effectors) {
  const auto share_a_joint = [](const Effector& a, const Effector& b) {
    return std::find_first_of(a.chain.begin(), a.chain.end(), b.chain.begin(), b.chain.end()) !=
           a.chain.end();
  };
  std::vector<std::vector<Effector>> groups;
  for (const Effector& effector : effectors) {
    std::vector<Effector> joined = {effector};
    std::erase_if(groups, [&](const std::vector<Effector>& group) {
      const bool shares = std::any_of(group.begin(), group.end(), [&](const Effector& other) {
        return share_a_joint(effector, other);
      });
      if (shares) joined.insert(joined.begin(), group.begin(), group.end());
      return shares;
    });
    groups.push_back(std::move(joined));
  }
  std::vector<Limb> limbs;
  for (auto& group : groups) limbs.emplace_back(skeleton, std::move(group));
  return limbs;
}

void check_effectors(const Skeleton& skeleton, const std::vector<Effector>& effectors) {
  std::set<int> joints;
  for (const Effector& effector : effectors)
    if (!joints.insert(effector.joint).second)
      throw Error("the joint " + skeleton.joint(effector.joint).name + " is an effector twice");
  for (const Limb& limb : limbs_of(skeleton, effectors))
    if (std::ssize(limb.effectors()) > kMostEffectors || limb.angle_count() > kMostAngles)
      throw Error("the limb of " + skeleton.joint(limb.effectors().front().joint).name +
                  " has more effectors or angles than can be solved together");
}

}  // namespace mocapress
