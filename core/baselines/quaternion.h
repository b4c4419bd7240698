// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/methods/comparison_method.h"
#include "core/motion/clip.h"
#include "core/select/error_model.h"

namespace mocapress {

/// A clip's channels as signals with quaternions in place of angles: joint by joint its
/// translations, then w x y z of its rotation if it turns.
class QuaternionSignals {
 public:
  explicit QuaternionSignals(const Skeleton& skeleton);

  int count() const { return joints_.empty() ? 0 : joints_.back().end(); }

  /// frames x signals. Of the two quaternions of each rotation, the one next to that of the frame
  /// before.
  Eigen::MatrixXd of(const Clip& clip) const;

  /// The inverse. Quaternions may have any length.
  Clip clip_of(const Eigen::MatrixXd& signals, double sample_rate_hz) const;

  /// What small changes of `signals`, which are of(clip), do to the joints.
  SignalMoves moves(const Clip& clip, const Eigen::MatrixXd& signals) const;

  /// What makes signals comparable, as channel_scales() does channels.
  std::vector<double> scales() const;

 private:
  struct JointSignals {
    int joint;
    int first;                      // of the signals
    std::vector<int> translations;  // channels of the clip
    bool turns;

    int quaternion() const { return first + static_cast<int>(translations.size()); }
    int end() const { return quaternion() + (turns ? 4 : 0); }
  };

  const Skeleton& skeleton_;
  std::vector<JointSignals> joints_;
};

/// Adaptive wavelets on quaternions in place of angles; a detail is a number of coefficients.
const ComparisonMethod& quaternion_method();

}  // namespace mocapress
