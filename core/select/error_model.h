// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/motion/landmarks.h"
#include "core/select/linkage.h"
#include "core/select/point_term.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {

struct CompositeBody;

/// The movement that one unit of each signal gives its joint, at the original pose. Signals are in
/// the order of their joints.
struct SignalMoves {
  struct Place {
    int joint;
    bool rotates;  // true: about the joint's origin; false: translates
  };
  std::vector<Place> places;
  // frames x 3 * signals: axis times size of the small rotation (radians), or translation (cm), in
  // world space
  Eigen::MatrixXd axes;
};

/// eps_x as a quadratic form. Near the original pose of frame t a landmark moves by J_t e, where e
/// is the error of the channels, so that
///
///   eps_x^2 ~ (1/n) sum_t e_t^T G_t e_t,   G_t = J_t^T W J_t.
///
/// G_t is never built. Its entry for two channels is the work that the force caused by one does
/// along the movement of the other. That force acts on all landmarks below the lower channel
/// (linkage.h). Immutable; any number of states may share it. Takes 22 numbers for each channel and
/// frame in a skeleton with two channels a joint.
class ErrorModel {
 public:
  ErrorModel(const Skeleton& skeleton, const Clip& original, Weighting weighting);
  ErrorModel(const Skeleton& skeleton, const Clip& original, const MeasuredPoints& measured);

  /// A model of signals other than the skeleton's channels, which then take the place of "channels"
  /// below.
  ErrorModel(const Skeleton& skeleton, const Clip& original, const MeasuredPoints& measured,
             SignalMoves moves);

  int frames() const { return static_cast<int>(curvature_.rows()); }
  int channels() const { return static_cast<int>(curvature_.cols()); }

  /// D: the diagonal of G_t, frames x channels. (cm per unit of the channel)^2.
  const Eigen::MatrixXd& curvature() const { return curvature_; }

  /// True if G_t has an entry for two channels.
  bool are_related(int a, int b) const;
  /// The entry of G_t for two channels, at each frame.
  Eigen::ArrayXf entry(int a, int b) const;

  /// Fills the first columns and rows of `sums` with G for some channels, summed over the frames of
  /// a function, each weighted by the function's square. Entries that are zero are left as they
  /// are. G changes slowly, so only even frames are summed, and some 16 of them for long functions.
  /// Channels are in the order of their joints.
  void sum_squares(const std::vector<int>& channels, const ShortFunction& function,
                   Eigen::MatrixXf& sums) const;

  /// True if a channel moves a joint's origin; the velocity that a channel gives to points at
  /// `places` (frames x 3, cm, in world space): cm per unit.
  bool moves(int channel, int joint) const;
  Eigen::MatrixXd velocity(int channel, const Eigen::MatrixXd& places) const;

  /// Adds a term for points whose errors count differently (PointTerm).
  void add(const PointResponse& response);

  /// G times errors of all channels (frames x channels). The result has its frames rounded up to a
  /// multiple of eight. Faster than an ErrorSweep that changes no errors, with the same result.
  void find_gradient(const Eigen::MatrixXf& errors, Eigen::MatrixXf& gradient) const;

  /// gradient += G times an error of `delta` (one value a frame) in `channel` alone. Touches only
  /// the channels that share landmarks with it.
  void add_to_gradient(int channel, const Eigen::VectorXd& delta, Eigen::MatrixXd& gradient) const;

 private:
  friend class ErrorSweep;

  /// Signals, and places of joints' origins and of measured points: frames x 3 * each, cm.
  struct Posed {
    SignalMoves moves;
    Eigen::MatrixXd origins;
    Eigen::MatrixXd points;
  };
  static Posed pose_channels(const Skeleton& skeleton, const Clip& original,
                             const std::vector<Landmark>& points);
  ErrorModel(const Skeleton& skeleton, const MeasuredPoints& measured, Posed posed);
  void compute_motions(const Skeleton& skeleton, const MeasuredPoints& measured,
                       const SignalMoves& moves, const Eigen::MatrixXd& point_tracks);
  /// `body`: everything that a joint moves, relative to the joint.
  void set_joint(int j, const CompositeBody& body, const Eigen::MatrixXd& axes, Eigen::Index first,
                 Eigen::Index frames);
  const LinkageJoint& joint_of(int channel) const {
    return linkage_[static_cast<std::size_t>(places_[static_cast<std::size_t>(channel)].joint)];
  }

  std::vector<SignalMoves::Place> places_;
  std::vector<LinkageJoint> linkage_;
  Eigen::MatrixXd origins_;                // frames x 3 * joints, cm
  std::vector<std::uint8_t> is_moved_by_;  // channels x channels, row by row
  // Movement and force of each channel relative to one place, for sum_squares(). For every second
  // frame: turn and shift, two zeros, torque and force, two zeros; 16 * frames / 2 x channels.
  Eigen::MatrixXf samples_;
  Eigen::MatrixXd curvature_;
  std::vector<PointTerm> terms_;
};

/// The present error of a set of channels, and its cost.
class ErrorState {
 public:
  /// Starts without an error in any channel.
  explicit ErrorState(const ErrorModel& model);

  /// Adds `delta` (one value a frame) to the error of `channel`.
  void add(int channel, const Eigen::VectorXd& delta);

  /// The change of squared_eps() that add() would make. O(frames).
  double change(int channel, const Eigen::VectorXd& delta) const;

  double squared_eps() const { return squared_eps_; }            // cm^2
  const Eigen::MatrixXd& gradient() const { return gradient_; }  // G e: frames x channels

 private:
  const ErrorModel* model_;
  Eigen::MatrixXd gradient_;
  double squared_eps_ = 0;
};

}  // namespace mocapress
