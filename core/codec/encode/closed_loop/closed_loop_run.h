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

/// One quantisation under way: values of the coefficients, what they do to the channels, and what
/// that does to eps_x.
class ClosedLoopRun {
 public:
  /// Begins with every coefficient cut to steps of that scale. Both references must outlive this.
  ClosedLoopRun(const ClosedLoop& loop, double scale, const Eigen::VectorXd& frame_weights);

  /// Begins with what was quantised before.
  ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                const Eigen::VectorXd& frame_weights);

  /// Begins where another run was settled or coarsened.
  ClosedLoopRun(const ClosedLoop& loop, ClosedLoop::Result settled);

  ClosedLoop::Result run(ClosedLoopWork work, const Observer<ClosedLoopProgress>& observer);

  /// The first of the sweeps that settle. Returns about the eps_x that all of them will leave.
  double begin_settling();

  /// What remains of these sweeps, and some more until eps_x is what was asked for. Only the latter
  /// where another run was settled before.
  ClosedLoop::Result settle(double eps_cm, const Observer<ClosedLoopProgress>& observer);
  ClosedLoop::Result coarsen(ErrorBound& bound, const Observer<ClosedLoopProgress>& observer);

 private:
  using Samples = Eigen::Ref<const Eigen::ArrayXf>;

  /// How many coefficients of each band of a channel are not zero.
  using Significant = std::vector<int>;

  /// A coefficient of one channel, and what moving it by whole steps does to the error: by x steps,
  /// 2 slope x + curve x^2 with all others as they are.
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

  /// Visits channels, from the root to the leaves, with the gradient of each.
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

  /// Moves the channel that is being visited, whose gradient was that.
  void move(int j, const Samples& gradient, const Samples& delta);

  /// Moves a channel to where it should be, given everyone else's error, if that pays.
  void compensate(int j);

  /// Moves each coefficient of a channel to the cheapest of the values around its best one.
  void sweep(int j);

  /// What the gradient of the channel that is being visited comes to in each coefficient.
  void find_slopes();

  /// Moves the coefficients that all channels have at a time and scale together: joint_search.h.
  void sweep_together();

  /// What moves together: what the gradient comes to in each coefficient (coefficients, and what
  /// makes them a whole number of eights, x channels), and of each the channels that take part.
  struct Together {
    Eigen::MatrixXf slopes;
    std::vector<std::vector<int>> taking_part;
  };
  void find_taking_part(int j, int band);

  /// Adds to the moves of each channel, in steps; empty where there is none.
  void move_together(int band, int index, std::vector<Eigen::ArrayXf>& moves);

  /// Whether the frames of a function weigh alike, more or less. Where a few count far more than
  /// those around, all that reach there would answer to the same error at once, and together
  /// overshoot.
  bool weigh_alike(const ShortFunction& function) const;

  /// Of the errors as they are. Prices the ends by it.
  void find_energy();

  int channels() const { return loop_.transform_.channels(); }
  bool is_still(int j) const { return loop_.still_[static_cast<std::size_t>(j)]; }
  double lambda() const { return bit_price_ * coded_.scale * coded_.scale; }  // cm^2 for a bit

  /// The same of a coefficient, whatever its channel.
  double lambda_of(int coefficient) const;

  /// Begins with prices of their own at the ends: where a mean error is sought, in all but short
  /// clips. A bound holds at the ends, too.
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

  /// By rates learned from the values as they are.
  double total_bits();

  /// By the channel's curvature; finer where it stands still, for its error stays for the whole
  /// clip.
  int step_exponent_of(int j) const;

  /// The coefficients of a channel in whole steps, each after so much was taken off it.
  Eigen::VectorXi quantised(int j, const Samples& less) const;

  /// What so many steps of a channel's coefficients come to.
  Eigen::ArrayXf samples_of(int j, Eigen::ArrayXf steps) const;

  /// A step of a channel's coefficients in a band.
  double step_in(int j, int band) const {
    const auto& [first, size] = bands_[static_cast<std::size_t>(band)];
    return size > 0 ? coded_.step(j) / loop_.gains_(first) : coded_.step(j);
  }

  /// What `delta` in channel j, from frame `first` on, would add to the sum of squared errors.
  double energy_of(int j, Eigen::Index first, const Samples& gradient, const Samples& delta) const;

  /// `step` is step_in(), `product` the gradient's with the synthesis function.
  Place place_of(int j, int band, int index, double step, double product) const;

  /// By how many steps to move a coefficient.
  int best_move(const Place& place) const;

  /// The bits that depend on a coefficient, were it one value or another.
  class Bits {
   public:
    Bits(const ClosedLoopRun& run, const Place& place);
    double with(int value) const;

   private:
    std::optional<RateTable::Around> around_;  // of details
    double waking_ = 0;
    int before_ = 0;  // coarse samples beside it
    std::optional<int> after_;
  };

  /// What a band takes for being something, if this coefficient alone decides that: one that is
  /// zero throughout takes next to nothing.
  double waking_bits(const Place& place) const;
  void set(const Place& place, int value);

  /// Those of the sweeps that settle which were not done yet.
  void settle_by_prices(ClosedLoop::Result& result, const Observer<ClosedLoopProgress>& observer);

  /// Over all coefficients, those of all channels together before where that is due.
  void sweep_all(ClosedLoop::Result& result, const Observer<ClosedLoopProgress>& observer);

  /// After all values of a channel have changed.
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
  Eigen::MatrixXf weighted_curvature_;
  Eigen::MatrixXf weighted_coefficient_curvature_;
  RateTable rates_;
  QuantisedSignals coded_;
  std::vector<Magnitudes> magnitudes_;  // of each channel's values
  std::vector<Significant> significant_;
  Eigen::MatrixXf errors_;  // frames x channels: decoded minus original
  double energy_ = 0;       // the sum of squared errors that makes, frames weighted
  double bit_price_;        // squared steps of error
  int settling_ = 0;        // of the sweeps that settle: how many there were
  double growth_ = 0;       // of eps_x in the last sweep of a settling: a logarithm
  std::optional<EndPrices> end_prices_;
  std::vector<EndPrices::Reach> reaches_;  // of coefficients, for these
  ErrorBound* bound_ = nullptr;            // that must hold, if any
  std::optional<ErrorSweep> under_way_;    // the pass under way
  Eigen::ArrayXf gradient_;  // where it is, frames weighted; zeros beyond the last frame
  // Memory of sweeps: what they add to a channel, and what its coefficients would gain.
  Eigen::ArrayXf delta_;  // zeros beyond the last frame
  Eigen::ArrayXf slopes_;
  Together together_;
};

}  // namespace mocapress
