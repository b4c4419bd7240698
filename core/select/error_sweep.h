// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/select/error_model.h"

namespace mocapress {

/// The gradient G e of eps_x^2, channel after channel from the root to the leaves, while the errors
/// of those that were passed change on the way.
///
/// As in the recursive Newton-Euler algorithm, what comes from above is the motion that the errors
/// above give a joint, and what comes from below the force that the errors below call up; so a
/// channel takes a time that does not depend on how many are related to it.
class ErrorSweep {
 public:
  /// `errors` are frames x channels. Both must outlive the sweep.
  ErrorSweep(const ErrorModel& model, const Eigen::MatrixXf& errors);

  /// Begins anew with the errors as they are now, in the memory it has.
  void restart();

  /// Whether a channel has been entered since.
  bool is_under_way() const { return channel_ >= 0; }

  /// e^T G e of each frame, as the errors were when it began.
  auto energies() const { return energies_.head(model_.frames()); }

  /// Enters the next channel, 0 first. Returns the gradient there, one value a frame, which stands
  /// until the next one is entered.
  Eigen::Ref<const Eigen::ArrayXf> next();

  /// The same again.
  Eigen::Ref<const Eigen::ArrayXf> gradient() const { return gradient_.head(model_.frames()); }

  /// The error of the channel entered last grows by `delta`.
  void add(const Eigen::Ref<const Eigen::ArrayXf>& delta);

 private:
  JointState* state_of(int joint) {
    return joint < 0 ? nullptr : states_.data() + joint * all_.eights();
  }
  ErrorColumns errors() const { return {errors_.data(), errors_.rows()}; }
  void enter_joint(int joint);

  const ErrorModel& model_;
  const Eigen::MatrixXf& errors_;
  FrameRange all_;
  int channel_ = -1;
  int joint_ = -1;                         // whose motion is known, and of all before it
  std::vector<JointState> states_;         // joint after joint
  Eigen::ArrayXf energies_;                // to a whole number of eights
  Eigen::ArrayXf gradient_;                // likewise
  std::vector<Eigen::MatrixXf> of_terms_;  // what the model's terms make of the errors
};

}  // namespace mocapress
