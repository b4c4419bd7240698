// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/codec/encode/closed_loop.h"
#include "core/codec/encode/rate_table.h"
#include "core/select/error_sweep.h"

namespace mocapress {

/// One quantisation under way: values of the coefficients, what they do to the channels, and what
/// that does to eps_x.
class ClosedLoopRun {
 public:
  /// Begins with every coefficient cut to steps of that scale. Both references must outlive this.
  ClosedLoopRun(const ClosedLoop& loop, double scale, const Eigen::VectorXd& frame_weights);

  /// Begins with what was quantised before.
  ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                const Eigen::VectorXd& frame_weights);

  ClosedLoop::Result run(const ClosedLoopWork& work, const Observer<ClosedLoopProgress>& observer);

  /// The first of so many sweeps. Returns about the eps_x that all of them will leave.
  double begin_sweeps(const ClosedLoopWork& work);

  /// What remains of the sweeps, and some more until eps_x is what was asked for.
  ClosedLoop::Result settle(double eps_cm, const ClosedLoopWork& work,
                            const Observer<ClosedLoopProgress>& observer);
  ClosedLoop::Result coarsen(ErrorBound& bound, const Observer<ClosedLoopProgress>& observer);

 private:
  /// How many coefficients of each band of a channel are not zero.
  using Significant = std::vector<int>;

  /// A coefficient of one channel, and what moving it by whole steps does to the error: by x steps,
  /// 2 slope x + curve x^2 with all others as they are.
  struct Place {
    int channel;
    int band;
    int index;  // in the band
    SynthesisFunction function;
    double step;
    double slope;
    double curve;
  };

  ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights);
  void begin();

  /// Visits every channel, from the root to the leaves, with its gradient.
  template <typename Visit>
  void pass(const Visit& visit) {
    if (errors_.rows() == 0) return;  // no frames, no errors
    if (under_way_)
      under_way_->restart();
    else
      under_way_.emplace(loop_.model_, errors_);
    for (int j = 0; j < channels(); ++j) {
      gradient_ = under_way_->next();
      if (weighted()) gradient_.array() *= frame_weights_.array();
      visit(j);
    }
  }

  /// Moves the channel that is being visited.
  void move(int j, const Eigen::VectorXd& delta);

  /// Moves a channel to where it should be, given everyone else's error, if that pays.
  void compensate(int j);

  /// Moves each coefficient of a channel to the cheapest of the values around its best one.
  void sweep(int j);

  /// Moves coefficients of two channels at a time: what neither would do alone, as it makes an
  /// error that the other makes good. Where frames and points count alike.
  void sweep_pairs();
  void sweep_pair(int a, int b, Eigen::MatrixXd& gradient);

  /// What moves of both add to the sum of squared errors.
  static double error_of(const Place& a, int by_a, const Place& b, int by_b, double cross);

  /// Whether any move of both could pay, whatever it saves.
  bool may_pay(const Place& a, const Place& b, double cross) const;
  std::pair<int, int> best_moves(const Place& a, const Significant& significant_in_a,
                                 const Place& b, const Significant& significant_in_b, double cross);
  void move_of_pair(const Place& place, int steps, int first_channel, Significant& significant,
                    Eigen::MatrixXd& gradient);

  int channels() const { return loop_.transform_.channels(); }
  double lambda() const { return bit_price_ * coded_.scale * coded_.scale; }  // cm^2 for a bit
  bool weighted() const { return frame_weights_.size() > 0; }
  const Eigen::MatrixXd& curvature() const {
    return weighted() ? weighted_curvature_ : loop_.curvature_;
  }
  const Eigen::MatrixXd& coefficient_curvature() const {
    return weighted() ? weighted_coefficient_curvature_ : loop_.coefficient_curvature_;
  }
  Clip decoded() const {
    return {loop_.original_.sample_rate_hz, loop_.original_.channels + errors_};
  }
  double eps_cm() const;

  /// By rates learned from the values as they are.
  double total_bits();

  Eigen::VectorXi quantised(int j, const Eigen::VectorXd& coefficients) const;

  /// What `delta` in channel j would add to the sum of squared errors.
  double energy_of(int j, const Eigen::VectorXd& delta) const;

  /// Adds that to energy_, of frames from `first` on.
  void add_energy(int j, Eigen::Index first, const Eigen::Ref<const Eigen::VectorXd>& gradient,
                  const Eigen::VectorXd& delta);

  Place place_of(int j, int band, int index,
                 const Eigen::Ref<const Eigen::VectorXd>& gradient) const;

  /// The same by the gradient's product with the synthesis function.
  Place place_of(int j, int band, int index, double product) const;

  /// By how many steps to move a coefficient.
  int best_move(const Place& place, const Significant& significant);

  /// The bits that depend on a coefficient, were it one value or another.
  class Bits {
   public:
    Bits(const ClosedLoopRun& run, const Place& place, const Significant& significant);
    double with(int value) const;

   private:
    std::optional<RateTable::Around> around_;  // of details
    double waking_ = 0;
    int before_ = 0;  // coarse samples beside it
    std::optional<int> after_;
  };

  /// What a band takes for being something, if this coefficient alone decides that: one that is
  /// zero throughout takes next to nothing.
  double waking_bits(const Place& place, const Significant& significant) const;
  Significant significant_in(int j) const;
  void set(const Place& place, int value, Significant& significant);
  int* values_of(int j) { return coded_.values.col(j).data(); }
  const int* values_of(int j) const { return coded_.values.col(j).data(); }
  int& value_at(const Place& place) {
    return values_of(
        place.channel)[bands_[static_cast<std::size_t>(place.band)].first + place.index];
  }

  const ClosedLoop& loop_;
  const std::vector<Band>& bands_;
  Eigen::VectorXd frame_weights_;  // empty: all alike
  Eigen::MatrixXd weighted_curvature_;
  Eigen::MatrixXd weighted_coefficient_curvature_;
  RateTable rates_;
  QuantisedSignals coded_;
  Eigen::MatrixXd errors_;               // frames x channels: decoded minus original
  double energy_ = 0;                    // the sum of squared errors that makes, frames weighted
  double bit_price_;                     // squared steps of error
  ErrorBound* bound_ = nullptr;          // that must hold, if any
  std::optional<ErrorSweep> under_way_;  // the pass under way
  Eigen::VectorXd gradient_;             // where it is, frames weighted
};

}  // namespace mocapress
