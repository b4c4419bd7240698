// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "core/codec/count_search.h"
#include "core/codec/target.h"
#include "core/motion/clip.h"
#include "core/motion/landmarks.h"

namespace mocapress {

/// A target put to one clip: how near a coded clip comes, and whether that keeps the promise.
/// An "excess" is the logarithm of what was reached over what was asked, signed so that it grows
/// with the number of coefficients.
class Goal {
 public:
  /// `original_tracks` are landmark_tracks() of the motion; both must outlive the goal.
  Goal(const Motion& motion, const Eigen::MatrixXd& original_tracks, const Target& target,
       Weighting weighting)
      : motion_(motion),
        original_tracks_(original_tracks),
        target_(target),
        weighting_(weighting) {}

  /// The target's quantity for a coded clip, which is only decoded for the errors.
  double achieved(std::size_t motion_bytes, const std::function<Clip()>& decoded) const;
  double excess(double achieved) const;

  /// Not on the forbidden side of a bound; within 2 % of a ratio.
  bool met(double excess) const;

  /// Throws TargetMissed unless met. Coding every coefficient in less space than asked for keeps
  /// the promise too.
  void require_met(double excess, double achieved, bool everything_kept) const;

  /// Raises the weights of frames at which a clip exceeds a hard maximum.
  void raise_where_exceeded(const Clip& decoded, Eigen::VectorXd& weights) const;

  /// Whether `excess` is a better outcome than `other`: a kept promise first, then nearness.
  bool better(double excess, double other) const;

  /// Excesses so near to the target that a search need not go on.
  CountSearch::Window window() const;

  /// A first guess at the paper's r.
  double likely_coefficient_ratio() const;

 private:
  const Motion& motion_;
  const Eigen::MatrixXd& original_tracks_;
  Target target_;
  Weighting weighting_;
};

}  // namespace mocapress
