// SPDX-License-Identifier: MIT
#pragma once

#include "core/codec/clip_analysis.h"
#include "core/codec/compressed_clip.h"
#include "core/codec/count_search.h"
#include "core/codec/target.h"

namespace mocapress {

/// A target put to one clip: how near a coded clip comes, and whether that keeps the promise.
/// An "excess" is the logarithm of what was reached over what was asked, signed so that it grows
/// with the number of coefficients.
class Goal {
 public:
  Goal(const ClipAnalysis& analysis, const Target& target, Weighting weighting)
      : analysis_(analysis), target_(target), weighting_(weighting) {}

  /// The target's quantity for this coded clip. For the errors this decodes it.
  double achieved(const CompressedClip& compressed) const;
  double excess(double achieved) const;

  /// Not on the forbidden side of a bound; within 2 % of a ratio.
  bool met(double excess) const;

  /// Whether `excess` is a better outcome than `other`: a kept promise first, then nearness.
  bool better(double excess, double other) const;

  /// Excesses so near to the target that a search need not go on.
  CountSearch::Window window() const;

  /// A first guess at the paper's r.
  double likely_coefficient_ratio() const;

 private:
  const ClipAnalysis& analysis_;
  Target target_;
  Weighting weighting_;
};

}  // namespace mocapress
