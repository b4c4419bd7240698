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
  /// `errors` are frames x channels. Both must outlive the sweep; the model's channels are in the
  /// order of their joints.
  ErrorSweep(const ErrorModel& model, const Eigen::MatrixXf& errors);

  /// Begins anew with the errors as they are now, in the memory it has.
  void restart();

  /// Enters the next channel, 0 first. Returns the gradient there, one value a frame, which stands
  /// until the next one is entered.
  const Eigen::ArrayXf& next();

  /// The same again.
  const Eigen::ArrayXf& gradient() const { return gradient_; }

  /// The error of the channel entered last grows by `delta`.
  void add(const Eigen::Ref<const Eigen::ArrayXf>& delta);

 private:
  void enter_joint(int joint);

  const ErrorModel& model_;
  const Eigen::MatrixXf& errors_;
  int channel_ = -1;
  int joint_ = -1;              // whose motion is known, and of all before it
  Eigen::MatrixXf motions_;     // that the errors give each joint: frames x 6 * joints
  Eigen::MatrixXf forces_;      // that errors below each joint call up: frames x 6 * joints
  std::vector<bool> is_begun_;  // joints whose forces have begun to be summed
  Eigen::ArrayXf gradient_;
  std::vector<Eigen::MatrixXf> of_terms_;  // what the model's terms make of the errors
};

}  // namespace mocapress
