// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"
#include "core/select/error_model.h"

namespace mocapress {

/// A clip's channels as signals, with quaternions in place of angles. Joint by joint: its
/// translations, then w x y z of its rotation if it has any.
class QuaternionSignals {
 public:
  explicit QuaternionSignals(const Skeleton& skeleton);

  int count() const { return joints_.empty() ? 0 : joints_.back().end(); }

  /// The signals of a clip: frames x signals. A rotation has two quaternions; this takes the one
  /// nearer to the previous frame's.
  Eigen::MatrixXd of(const Clip& clip) const;

  /// The clip with these signals. Quaternions may have any length.
  Clip clip_of(const Eigen::MatrixXd& signals, double sample_rate_hz) const;

  /// The movements of joints for small changes of `signals`, which must be of(clip).
  SignalMoves moves(const Clip& clip, const Eigen::MatrixXd& signals) const;

  /// Factors that make the signals comparable, as channel_scales() does for channels.
  std::vector<double> scales() const;

 private:
  struct JointSignals {
    int joint;
    int first;                      // first signal
    std::vector<int> translations;  // indices of the clip's channels
    bool turns;

    int quaternion() const { return first + static_cast<int>(translations.size()); }
    int end() const { return quaternion() + (turns ? 4 : 0); }
  };

  const Skeleton& skeleton_;
  std::vector<JointSignals> joints_;
};

}  // namespace mocapress
