// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>

#include "core/codec/encode/options/target.h"
#include "core/codec/encode/search/count_search.h"
#include "core/codec/format/compressed_clip.h"
#include "core/metrics/end_errors.h"
#include "core/metrics/visibility.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// The motion that decoded clips are compared with, landmark by landmark, a block of frames at a
/// time.
class Original {
 public:
  using Tracks = std::function<const Eigen::MatrixXd&()>;

  /// `tracks` returns the motion's body_tracks() when they are first needed. Without it, tracks are
  /// computed a block of frames at a time and never kept. The motion must outlive this object.
  explicit Original(const Motion& motion, Tracks tracks = {})
      : motion_(motion), tracks_(std::move(tracks)) {}

  const Motion& motion() const { return motion_; }

  /// Receives rows of body_tracks() of both clips from first_frame on, in time order, each frame
  /// once.
  using Visit =
      std::function<void(int first_frame, const TrackRows& original, const TrackRows& decoded)>;

  /// Compares with decoded frames from first_frame on. Their skeleton may have other channels than
  /// the original, but must have the same bones.
  void compare(int first_frame, const Skeleton& skeleton, const Clip& decoded,
               const Visit& visit) const;

  /// Compares with a whole compressed clip, in memory that does not grow with its segments.
  void compare(const CompressedClip& compressed, const Visit& visit) const;

 private:
  const Motion& motion_;
  Tracks tracks_;
};

/// A selection of coefficients, coded, and its distance from a goal. The provenance is not set. A
/// draft may have quantised values but no coded motion yet.
struct Trial {
  CompressedClip compressed;
  int count = 0;         // number of coefficients kept
  double scale = 0;      // closed loop
  double eps_cm = 0;     // closed loop, by the quadratic model
  double bit_price = 0;  // closed loop: see ClosedLoop::Result
  double growth = 0;
  int iterations = 0;                      // in the last annealing, or sweeps of the closed loop
  bool complete = true;                    // false: the observer stopped it
  double achieved = 0;                     // in the quantity of the target
  double excess = 0;                       // see Goal
  double correction_ratio = 0;             // r_IK, given or found
  std::optional<double> slide_without_cm;  // footskate without correction, where r_IK was found
};

/// A target for one clip. Measures how near a coded clip comes to the target and whether it meets
/// it. An "excess" is the logarithm of the achieved over the target value, signed so that it grows
/// with the number of coefficients.
class Goal {
 public:
  /// Visibility is measured with `contacts` of the feet and `limits`. `frame_factors` multiply the
  /// errors of each frame: see frame_factors(). If empty, all frames count alike.
  Goal(Original original, const Target& target, Weighting weighting,
       std::vector<ContactSpan> contacts, Eigen::VectorXd frame_factors = {},
       const SightLimits& limits = {})
      : original_(std::move(original)),
        target_(target),
        weighting_(weighting),
        contacts_(std::move(contacts)),
        frame_factors_(std::move(frame_factors)),
        limits_(limits) {}

  /// The target's quantity for a coded clip, which is decoded only if the target is an error.
  double achieved(const CompressedClip& compressed) const;
  double achieved(std::size_t motion_bytes, const std::function<Clip()>& decoded) const;
  double excess(double achieved) const;

  /// A bound must not be exceeded; a ratio is met within 2 %.
  bool met(double excess) const;

  /// Throws TargetMissed unless the target is met. Coding every coefficient in less space than
  /// asked for also counts.
  void require_met(double excess, double achieved, bool everything_kept) const;

  /// Measures the visible errors of a coded clip.
  Visibility seen(const CompressedClip& compressed) const;

  /// Errors of the first and the last pose, and of the seam between them.
  EndErrors ends(const CompressedClip& compressed) const;

  /// The hard maximum at each of `frames` frames, in cm.
  Eigen::VectorXd bounds(int frames) const;

  /// Error of the worst point at each frame, in cm, times the frame's factor.
  Eigen::VectorXd worst_of_frames(const CompressedClip& compressed) const;

  /// Raises the weights of frames at which a clip exceeds a hard maximum or is noticed.
  void raise_where_exceeded(const CompressedClip& compressed, Eigen::VectorXd& weights) const;

  /// Returns whether `excess` is a better outcome than `other`: meeting the target comes first,
  /// then nearness.
  bool better(double excess, double other) const;

  /// Excesses so near to the target that a search may end.
  CountSearch::Window window() const;

  /// A first guess at the paper's r.
  double likely_coefficient_ratio() const;

 private:
  /// Calls the visitor with decoded and original frames.
  using Comparison = std::function<void(const Original::Visit&)>;
  double achieved(std::size_t motion_bytes, const Comparison& compare) const;
  Visibility seen(const Comparison& compare) const;
  double most_noticed(const Visibility& seen) const;
  double factor_at(Eigen::Index frame) const {
    return frame_factors_.size() > 0 ? frame_factors_(frame) : 1;
  }

  Original original_;
  Target target_;
  Weighting weighting_;
  std::vector<ContactSpan> contacts_;
  Eigen::VectorXd frame_factors_;  // empty: all alike
  SightLimits limits_;
};

}  // namespace mocapress
