// SPDX-License-Identifier: MIT
#include "core/select/error_sweep.h"

#include <algorithm>

namespace mocapress {
namespace {

/// Frames at a time; with this many, all forces stay in the cache until the joints above need them.
constexpr Eigen::Index kTile = 512;

}  // namespace

ErrorSweep::ErrorSweep(const ErrorModel& model, const Eigen::MatrixXf& errors)
    : model_(model),
      errors_(errors),
      all_{0, model.frames()},
      states_(model.linkage_.size() * static_cast<std::size_t>(all_.eights())),
      energies_(EightFrames::kCount * all_.eights()),
      gradient_(energies_.size()) {
  restart();
}

void ErrorSweep::restart() {
  channel_ = -1;
  joint_ = -1;
  energies_.setZero();
  for (Eigen::Index first = 0; first < all_.count; first += kTile) {
    const FrameRange frames{first, std::min(kTile, all_.count - first)};
    const Eigen::Index eight = first / EightFrames::kCount;
    for (int j = static_cast<int>(std::ssize(model_.linkage_)) - 1; j >= 0; --j) {
      const LinkageJoint& joint = model_.linkage_[j];
      JointState* const parent = state_of(joint.parent);
      hand_up(joint, errors(), frames, state_of(j) + eight, parent ? parent + eight : nullptr,
              energies_.data() + first);
    }
  }
  of_terms_.clear();
  for (const PointTerm& term : model_.terms_) {
    const Eigen::MatrixXf& forces = of_terms_.emplace_back(term.forces_of(errors_));
    for (int c = 0; c < model_.channels(); ++c) {
      Eigen::ArrayXf work = Eigen::ArrayXf::Zero(all_.count);
      term.add_work(c, forces, work);
      energies_.head(all_.count) += errors_.col(c).array() * work;
    }
  }
}

void ErrorSweep::enter_joint(int joint) {
  while (joint_ < joint) {
    const LinkageJoint& next = model_.linkage_[++joint_];
    enter(next, errors(), all_, state_of(next.parent), state_of(joint_));
  }
}

Eigen::Ref<const Eigen::ArrayXf> ErrorSweep::next() {
  ++channel_;
  const LinkageJoint& joint = model_.joint_of(channel_);
  enter_joint(model_.places_[channel_].joint);
  find_work(joint, channel_, all_, state_of(joint_), gradient_.data());
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_work(channel_, of_terms_[i], gradient_.head(all_.count));
  return gradient();
}

void ErrorSweep::add(const Eigen::Ref<const Eigen::ArrayXf>& delta) {
  const LinkageJoint& joint = model_.joint_of(channel_);
  add_error(joint, channel_, delta.data(), all_, channel_ + 1 < joint.end_channel(),
            state_of(joint_));
  for (std::size_t i = 0; i < of_terms_.size(); ++i)
    model_.terms_[i].add_forces(channel_, delta, of_terms_[i]);
}

}  // namespace mocapress
