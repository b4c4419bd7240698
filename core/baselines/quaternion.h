// SPDX-License-Identifier: MIT
#pragma once

#include "core/motion/clip.h"
#include "core/select/error_model.h"

namespace mocapress {

/// A clip's channels as signals, with quaternions in place of angles: joint by joint its
/// translations, then w x y z of its rotation if it turns.
class QuaternionSignals {
 public:
  explicit QuaternionSignals(const Skeleton& skeleton);

  int count() const { return joints_.empty() ? 0 : joints_.back().end(); }

  /// The signals: frames x signals. Each rotation has two quaternions, of which the one nearer to
  /// the last frame's is taken.
  Eigen::MatrixXd of(const Clip& clip) const;

  /// The clip of such signals. Quaternions may have any length.
  Clip clip_of(const Eigen::MatrixXd& signals, double sample_rate_hz) const;

  /// Movements of the joints by small changes of `signals`, which are of(clip).
  SignalMoves moves(const Clip& clip, const Eigen::MatrixXd& signals) const;

  /// Factors that make signals comparable, as channel_scales() does for channels.
  std::vector<double> scales() const;

 private:
  struct JointSignals {
    int joint;
    int first;                      // first signal
    std::vector<int> translations;  // the clip's channels
    bool turns;

    int quaternion() const { return first + static_cast<int>(translations.size()); }
    int end() const { return quaternion() + (turns ? 4 : 0); }
  };

  const Skeleton& skeleton_;
  std::vector<JointSignals> joints_;
};

}  // namespace mocapress
