// SPDX-License-Identifier: MIT
#include "core/ik/limb.h"

#include "core/base/error.h"
#include "core/runtime/ik/limb_planner.h"

namespace mocapress {
namespace {

runtime::JointModel model_of(const Skeleton& skeleton, int index) {
  const Joint& joint = skeleton.joint(index);
  runtime::JointModel model;
  model.parent = joint.parent;
  model.first_channel = static_cast<std::uint16_t>(skeleton.first_channel(index));
  model.channels = static_cast<std::uint8_t>(joint.channels.size());
  for (std::size_t c = 0; c < joint.channels.size(); ++c)
    model.kinds[c] = static_cast<std::uint8_t>(joint.channels[c]);
  const auto& [parent_from_axes, axes_from_joint] = skeleton.axes(index);
  model.has_end_site = joint.end_site.has_value();
  model.has_axes = !parent_from_axes.isIdentity(0) || !axes_from_joint.isIdentity(0);
  for (int i = 0; i < 3; ++i) {
    model.offset[i] = joint.offset(i);
    if (joint.end_site) model.end_site[i] = static_cast<float>((*joint.end_site)(i));
    for (int k = 0; k < 3; ++k) {
      model.parent_from_axes(i, k) = parent_from_axes(i, k);
      model.axes_from_joint(i, k) = axes_from_joint(i, k);
    }
  }
  return model;
}

std::vector<runtime::EffectorEnds> ends_of(const std::vector<Effector>& effectors) {
  std::vector<runtime::EffectorEnds> ends;
  for (const Effector& effector : effectors)
    ends.push_back({effector.joint, effector.chain.front()});
  return ends;
}

/// Runs the planner for a skeleton's limbs. Throws Error.
class Planned {
 public:
  Planned(const std::vector<runtime::JointModel>& joints, const std::vector<Effector>& effectors)
      : ends_(ends_of(effectors)), planner_(static_cast<int>(joints.size())) {
    if (effectors.size() > runtime::kMostEffectors)
      throw Error("more than " + std::to_string(runtime::kMostEffectors) + " effectors");
    if (const char* const wrong =
            planner_->plan(joints.data(), ends_.data(), static_cast<int>(ends_.size())))
      throw Error(wrong);
  }
  runtime::LimbPlanner* operator->() { return &*planner_; }

 private:
  std::vector<runtime::EffectorEnds> ends_;
  OwnMemory<runtime::LimbPlanner> planner_;
};

}  // namespace

std::vector<runtime::JointModel> models_of(const Skeleton& skeleton) {
  std::vector<runtime::JointModel> models;
  for (int j = 0; j < skeleton.joint_count(); ++j) models.push_back(model_of(skeleton, j));
  return models;
}

Limb::Limb(const Skeleton& skeleton, const std::vector<Effector>& effectors)
    : joints_(models_of(skeleton)), frame_(Eigen::RowVectorXd::Zero(skeleton.channel_count())) {
  Planned planned(joints_, effectors);
  if (planned->limb_count() != 1) throw Error("these effectors are not one limb");
  const runtime::LimbPlan size = planned->size(0);
  effector_numbers_.resize(effectors.size());
  effector_links_.resize(effectors.size());
  links_.resize(size.links);
  turns_.resize(size.turns);
  limb_ = std::make_unique<OwnMemory<runtime::Limb>>(size.links);
  (*limb_)->set(planned->lay_out(0, {effector_numbers_.data(), effector_links_.data(),
                                     links_.data(), turns_.data()}),
                joints_.data());
  for (const std::uint16_t number : effector_numbers_) effectors_.push_back(effectors[number]);
  (*limb_)->set_frame(frame_.data());
}

void Limb::set_frame(const FrameRow& frame) {
  frame_ = frame;
  (*limb_)->set_frame(frame_.data());
}

Eigen::VectorXd Limb::angles() const {
  Eigen::VectorXd angles(angle_count());
  for (int a = 0; a < angle_count(); ++a) angles(a) = (*limb_)->angle(a);
  return angles;
}

std::vector<Limb> limbs_of(const Skeleton& skeleton, const std::vector<Effector>& effectors) {
  const std::vector<runtime::JointModel> joints = models_of(skeleton);
  Planned planned(joints, effectors);
  std::vector<Limb> limbs;
  for (int l = 0; l < planned->limb_count(); ++l) {
    std::vector<Effector> of_limb;
    for (const int number : planned->effectors_of(l)) of_limb.push_back(effectors[number]);
    limbs.emplace_back(skeleton, of_limb);
  }
  return limbs;
}

void check_effectors(const Skeleton& skeleton, const std::vector<Effector>& effectors) {
  const std::vector<runtime::JointModel> joints = models_of(skeleton);
  Planned(joints, effectors);
}

}  // namespace mocapress
