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

/// What one unit more of each signal does to a joint, at the original pose. Signals are in the
/// order of their joints.
struct SignalMoves {
  struct Place {
    int joint;
    bool rotates;  // about the joint's origin; else translates
  };
  std::vector<Place> places;
  // frames x 3 * signals: axis and size of the small rotation (radians), or translation (cm), in
  // the world
  Eigen::MatrixXd axes;
};

/// eps_x as a quadratic form. Near the original pose of frame t a landmark moves by J_t e, with e
/// the error of the channels, so that
///
///   eps_x^2 ~ (1/n) sum_t e_t^T G_t e_t,   G_t = J_t^T W J_t.
///
/// No G_t is formed. Its entry for two channels is the work that the force called up by one does
/// along the motion of the other, where the force is that on all landmarks below the lower channel
/// (linkage.h). Immutable, shared by any number of states. 22 numbers a channel and frame where
/// joints have two.
class ErrorModel {
 public:
  ErrorModel(const Skeleton& skeleton, const Clip& original, Weighting weighting);
  ErrorModel(const Skeleton& skeleton, const Clip& original, const MeasuredPoints& measured);

  /// The same for signals other than the skeleton's channels, which stand for "channels" below.
  ErrorModel(const Skeleton& skeleton, const Clip& original, const MeasuredPoints& measured,
             SignalMoves moves);

  int frames() const { return static_cast<int>(curvature_.rows()); }
  int channels() const { return static_cast<int>(curvature_.cols()); }

  /// D: the diagonal of G_t, frames x channels. (cm per unit of the channel)^2.
  const Eigen::MatrixXd& curvature() const { return curvature_; }

  /// Whether G_t has an entry for two channels, and what it is at each frame.
  bool are_related(int a, int b) const;
  Eigen::ArrayXf entry(int a, int b) const;

  /// Writes G of some channels into the first columns and rows of `sums`, summed over the frames of
  /// a function, each counted by its square; what is zero stays as it is. How channels go together
  /// changes slowly: even frames tell, of long functions some 16 of them. Channels are in the order
  /// of their joints.
  void sum_squares(const std::vector<int>& channels, const ShortFunction& function,
                   Eigen::MatrixXf& sums) const;

  /// Whether a channel moves a joint's origin, and how it moves what is at `places` (frames x 3,
  /// cm, in the world): cm per unit.
  bool moves(int channel, int joint) const;
  Eigen::MatrixXd velocity(int channel, const Eigen::MatrixXd& places) const;

  /// Lets errors of some points count otherwise.
  void add(const PointResponse& response);

  /// G times errors of all channels (frames x channels): frames to a whole number of eights x
  /// channels. Frame by frame what an ErrorSweep finds as long as no error changes, in less time.
  void find_gradient(const Eigen::MatrixXf& errors, Eigen::MatrixXf& gradient) const;

  /// gradient += G times an error of `delta` (one value a frame) in `channel` alone.
  /// Touches only the channels that share landmarks with it.
  void add_to_gradient(int channel, const Eigen::VectorXd& delta, Eigen::MatrixXd& gradient) const;

 private:
  friend class ErrorSweep;

  /// Signals, and where joints' origins and measured points are: frames x 3 * each, cm.
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
  /// `body`: all that a joint moves, seen from it.
  void set_joint(int j, const CompositeBody& body, const Eigen::MatrixXd& axes, Eigen::Index first,
                 Eigen::Index frames);
  const LinkageJoint& joint_of(int channel) const {
    return linkage_[static_cast<std::size_t>(places_[static_cast<std::size_t>(channel)].joint)];
  }

  std::vector<SignalMoves::Place> places_;
  std::vector<LinkageJoint> linkage_;
  Eigen::MatrixXd origins_;                // of joints: frames x 3 * joints, cm
  std::vector<std::uint8_t> is_moved_by_;  // channels x channels, row by row
  // What each channel moves and calls up, seen from one place, for sum_squares(): turn and shift,
  // two zeros, torque and force, two zeros of every second frame; 16 * frames / 2 x channels.
  Eigen::MatrixXf samples_;
  Eigen::MatrixXd curvature_;
  std::vector<PointTerm> terms_;
};

/// The error of a set of channels so far, and what it costs.
class ErrorState {
 public:
  /// No error in any channel.
  explicit ErrorState(const ErrorModel& model);

  /// Adds `delta` (one value a frame) to the error of `channel`.
  void add(int channel, const Eigen::VectorXd& delta);

  /// What add() would do to squared_eps(). O(frames).
  double change(int channel, const Eigen::VectorXd& delta) const;

  double squared_eps() const { return squared_eps_; }            // cm^2
  const Eigen::MatrixXd& gradient() const { return gradient_; }  // G e: frames x channels

 private:
  const ErrorModel* model_;
  Eigen::MatrixXd gradient_;
  double squared_eps_ = 0;
};

}  // namespace mocapress
