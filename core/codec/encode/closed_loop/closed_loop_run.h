// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/codec/encode/closed_loop/closed_loop.h"
#include "core/codec/encode/closed_loop/end_prices.h"
#include "core/codec/encode/closed_loop/rate_table.h"
#include "core/select/error_sweep.h"

namespace mocapress {

/// One quantisation in progress: the coefficients' values, the errors that they leave in the
/// channels, and the resulting eps_x.
class ClosedLoopRun {
 public:
  /// Starts with every coefficient cut to steps of `scale`. The loop must outlive this object.
  ClosedLoopRun(const ClosedLoop& loop, double scale, const Eigen::VectorXd& frame_weights);

  /// Starts from an earlier quantisation.
  ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                const Eigen::VectorXd& frame_weights);

  /// Starts from the result of another run's settle() or coarsen().
  ClosedLoopRun(const ClosedLoop& loop, ClosedLoop::Result settled);

  ClosedLoop::Result run(ClosedLoopWork work, const Observer<ClosedLoopProgress>& observer);

  /// Settling is a series of sweeps, each with its own price of a bit. Runs the first of them.
  /// Returns an estimate of eps_x after the last one.
  double begin_settling();

  /// Runs the remaining settling sweeps, then more until eps_x is as asked. A run that started from
  /// a settled result does only the latter.
  ClosedLoop::Result settle(double eps_cm, const Observer<ClosedLoopProgress>& observer);
  ClosedLoop::Result coarsen(ErrorBound& bound, const Observer<ClosedLoopProgress>& observer);

 private:
  using Samples = Eigen::Ref<const Eigen::ArrayXf>;

  /// The number of coefficients that are not zero, for each band of a channel.
  using Significant = std::vector<int>;

  /// A coefficient of one channel. A move by x whole steps changes the weighted sum of squared
  /// errors by 2 slope x + curve x^2, if all other coefficients stay as they are.
  struct Place {
    int channel;
    int band;
    int index;  // in the band
    ShortFunction function;
    double step;
    double slope;
    double curve;
  };

  ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights);
  void begin();

  /// Visits channels from the root to the leaves, each with its gradient in gradient_.
  template <typename Visit>
  void pass(const Visit& visit) {
    if (errors_.rows() == 0) return;  // no frames, no errors
    if (under_way_->is_under_way()) under_way_->restart();
    for (int j = 0; j < channels(); ++j) {
      auto gradient = gradient_.head(errors_.rows());
      gradient = under_way_->next();
      if (weighted()) gradient *= frame_weights_;
      visit(j);
    }
  }

  /// Changes the channel that is being visited by `delta` and updates the energy; `gradient` is the
  /// channel's gradient before the change.
  void move(int j, const Samples& gradient, const Samples& delta);

  /// Quantises a channel anew so that it compensates the errors of the others, if that pays.
  void compensate(int j);

  /// Moves each coefficient of a channel to the cheapest value near its best one.
  void sweep(int j);

  /// Computes the slope of each coefficient from the gradient of the channel being visited.
  void find_slopes();

  /// Moves coefficients of several channels at once: those of all channels at the same time and
  /// scale (joint_search.h).
  void sweep_together();

  /// Coefficients that move together. `slopes` holds the slope of each coefficient (rows padded to
  /// a multiple of eight, x channels); `taking_part` lists the participating channels of each
  /// coefficient.
  struct Together {
    Eigen::MatrixXf slopes;
    std::vector<std::vector<int>> taking_part;
  };
  void find_taking_part(int j, int band);

  /// Adds to each channel's moves, in steps; an empty array means no moves.
  void move_together(int band, int index, std::vector<Eigen::ArrayXf>& moves);

  /// Returns whether the frames of a synthesis function weigh about alike. If a few frames weigh
  /// far more, all coefficients that reach them would respond to the same error at once and
  /// overshoot.
  bool weigh_alike(const ShortFunction& function) const;

  /// Computes energy_ from errors_, and updates the prices at the clip's ends.
  void find_energy();

  int channels() const { return loop_.transform_.channels(); }
  bool is_still(int j) const { return loop_.still_[static_cast<std::size_t>(j)]; }
  // Price of a bit, in cm^2 of weighted squared error.
  double lambda() const { return bit_price_ * coded_.scale * coded_.scale * largest_weight_; }

  /// Like lambda(), for one coefficient (any channel): cheaper near the ends.
  double lambda_of(int coefficient) const;

  /// Turns on separate prices for the clip's ends, except in short clips. Called where a mean error
  /// is sought; a bound protects the ends by itself.
  void spare_ends();

  bool weighted() const { return frame_weights_.size() > 0; }
  const Eigen::MatrixXf& curvature() const {
    return weighted() ? weighted_curvature_ : loop_.curvature_;
  }
  const Eigen::MatrixXf& coefficient_curvature() const {
    return weighted() ? weighted_coefficient_curvature_ : loop_.coefficient_curvature_;
  }
  Clip decoded() const {
    return {loop_.original_.sample_rate_hz, loop_.original_.channels + errors_.cast<double>()};
  }
  double eps_cm() const;

  /// Estimates the bits of all channels.
  double total_bits();

  /// The step exponent that follows from the channel's mean curvature.
  int step_exponent_of(int j) const;

  /// The step exponent of a channel that stands still. The step of its coarse samples depends only
  /// on the scale and, if huge, the value, so that segments of all lengths get the same value.
  int step_exponent_of_still(int j) const;

  /// The coefficients of a channel that stands still: one value.
  Eigen::VectorXi constant(int j) const;

  /// A channel's coefficients in whole steps, after `less` was subtracted from each.
  Eigen::VectorXi quantised(int j, const Samples& less) const;

  /// The samples that result from a channel's coefficients, given in steps.
  Eigen::ArrayXf samples_of(int j, Eigen::ArrayXf steps) const;

  /// The quantisation step of a channel's coefficients in a band.
  double step_in(int j, int band) const {
    const auto& [first, size] = bands_[static_cast<std::size_t>(band)];
    return size > 0 ? coded_.step(j) / loop_.gains_(first) : coded_.step(j);
  }

  /// Change of the sum of squared errors if `delta` were added to channel j from frame `first` on.
  double energy_of(int j, Eigen::Index first, const Samples& gradient, const Samples& delta) const;

  /// `step` is step_in(); `product` is the dot product of the gradient and the synthesis function.
  Place place_of(int j, int band, int index, double step, double product) const;

  /// The number of steps by which to move a coefficient.
  int best_move(const Place& place) const;

  /// The bits that depend on one coefficient, for any value it might take.
  class Bits {
   public:
    Bits(const ClosedLoopRun& run, const Place& place);
    double with(int value) const;

   private:
    std::optional<RateTable::Around> around_;  // for details
    double waking_ = 0;
    int before_ = 0;  // the coarse sample before; after_: the one behind
    std::optional<int> after_;
  };

  /// Extra bits of a band that is not all zero, or 0 if another of its coefficients is not zero. A
  /// band of zeros costs almost nothing.
  double waking_bits(const Place& place) const;
  void set(const Place& place, int value);

  /// Runs the settling sweeps that were not done yet.
  void settle_by_prices(ClosedLoop::Result& result, const Observer<ClosedLoopProgress>& observer);

  /// Sweeps all coefficients; in late sweeps, moves all channels' coefficients together first.
  void sweep_all(ClosedLoop::Result& result, const Observer<ClosedLoopProgress>& observer);

  /// Rereads the magnitudes of channel j after its values have changed.
  void look_at(int j);
  const Magnitudes& magnitudes_of(int j) const { return magnitudes_[static_cast<std::size_t>(j)]; }
  int* values_of(int j) { return coded_.values.col(j).data(); }
  const int* values_of(int j) const { return coded_.values.col(j).data(); }
  int coefficient_at(const Place& place) const {
    return bands_[static_cast<std::size_t>(place.band)].first + place.index;
  }
  int value_at(const Place& place) const { return values_of(place.channel)[coefficient_at(place)]; }

  const ClosedLoop& loop_;
  const std::vector<Band>& bands_;
  Eigen::ArrayXf frame_weights_;  // empty: all alike
  double largest_weight_ = 1;     // the largest weight of loop_
  Eigen::MatrixXf weighted_curvature_;
  Eigen::MatrixXf weighted_coefficient_curvature_;
  RateTable rates_;
  QuantisedSignals coded_;
  std::vector<Magnitudes> magnitudes_;  // one for each channel
  std::vector<Significant> significant_;
  Eigen::MatrixXf errors_;  // frames x channels: decoded minus original
  double energy_ = 0;       // sum of squared errors, frames weighted
  double bit_price_;        // squared steps of error
  int settling_ = 0;        // number of settling sweeps done
  double growth_ = 0;       // logarithm by which the last settling sweep changed eps_x
  std::optional<EndPrices> end_prices_;
  std::vector<EndPrices::Reach> reaches_;  // one for each coefficient, for end_prices_
  ErrorBound* bound_ = nullptr;            // the bound to keep, if any
  std::optional<ErrorSweep> under_way_;    // the pass under way
  Eigen::ArrayXf gradient_;  // the visited channel's, frames weighted; zeros beyond the last frame
  // Buffers of sweeps: the change of a channel, and the slopes of its coefficients.
  Eigen::ArrayXf delta_;  // zeros beyond the last frame
  Eigen::ArrayXf slopes_;
  Together together_;
};

}  // namespace mocapress
