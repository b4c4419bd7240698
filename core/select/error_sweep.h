// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/select/error_model.h"

namespace mocapress {

/// The gradient G e of eps_x^2, visited channel after channel from the root to the leaves, while
/// errors of visited channels may change on the way.
///
/// As in the recursive Newton-Euler algorithm, errors above give a joint its movement, and errors
/// below give it a force. So each channel takes a time that does not depend on the number of
/// channels related to it.
class ErrorSweep {
 public:
  /// `errors` are frames x channels. Both must outlive the sweep.
  ErrorSweep(const ErrorModel& model, const Eigen::MatrixXf& errors);

  /// Begins again with the present errors, reusing its memory.
  void restart();

  /// True if next() was called since the start.
  bool is_under_way() const { return channel_ >= 0; }

  /// e^T G e for each frame, with the errors at the start.
  auto energies() const { return energies_.head(model_.frames()); }

  /// Enters the next channel, 0 first. Returns its gradient, one value a frame, which stays valid
  /// until the next call.
  Eigen::Ref<const Eigen::ArrayXf> next();

  /// The gradient of the channel entered last.
  Eigen::Ref<const Eigen::ArrayXf> gradient() const { return gradient_.head(model_.frames()); }

  /// Adds `delta` to the error of the channel entered last.
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
  int joint_ = -1;                         // movements are known up to this joint
  std::vector<JointState> states_;         // joint by joint
  Eigen::ArrayXf energies_;                // frames rounded up to a multiple of eight
  Eigen::ArrayXf gradient_;                // likewise
  std::vector<Eigen::MatrixXf> of_terms_;  // forces from each of the model's terms
};

}  // namespace mocapress
