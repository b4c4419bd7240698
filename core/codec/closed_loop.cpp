// SPDX-License-Identifier: MIT
#include "core/codec/closed_loop.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/codec/rate_table.h"
#include "core/select/error_sweep.h"

namespace mocapress {
namespace {

constexpr double kDeadZone = 0.1;   // what is added before details are cut to whole steps
constexpr double kBitPrice = 0.04;  // squared steps of error that a bit is worth
constexpr double kLeastMoved =
    1e-4;  // of the mean curvature: what moves no landmark counts so much

}  // namespace

ClosedLoop::ClosedLoop(const Coefficients& transform, const Clip& original, const ErrorModel& model)
    : transform_(transform),
      original_(original),
      model_(model),
      synthesis_(transform.lifting),
      curvature_(model.curvature()) {
  const std::vector<double> gains = transform.lifting.gains();
  gains_ = Eigen::Map<const Eigen::VectorXd>(gains.data(), std::ssize(gains));
  if (curvature_.size() > 0)
    curvature_ = curvature_.cwiseMax(std::max(kLeastMoved * curvature_.mean(), 1e-12)).eval();
  mean_curvature_ = curvature_.colwise().sum() / std::max(original.frames(), 1);
  mean_curvature_ = mean_curvature_.cwiseMax(1e-12).eval();
  coefficient_curvature_ = coefficient_curvature(curvature_);
}

Eigen::MatrixXd ClosedLoop::coefficient_curvature(const Eigen::MatrixXd& curvature) const {
  Eigen::MatrixXd of_coefficients(curvature.rows(), curvature.cols());
  parallel_for(Eigen::Index{0}, curvature.cols(), [&](Eigen::Index j) {
    for (int c = 0; c < transform_.per_channel(); ++c) {
      const SynthesisFunction function = synthesis_[c];
      of_coefficients(c, j) = function.values.cwiseAbs2().dot(
          curvature.col(j).segment(function.first, function.values.size()));
    }
  });
  return of_coefficients;
}

double ClosedLoop::finest_scale() const {
  double largest = 1e-6;
  for (int j = 0; j < transform_.channels(); ++j)
    if (original_.frames() > 0)
      largest =
          std::max(largest, transform_.values.col(j).cwiseProduct(gains_).cwiseAbs().maxCoeff() *
                                std::sqrt(mean_curvature_(j)));
  return 16 * largest / kMostSteps;
}

double likely_scale(const Target& target, std::size_t raw_bytes) {
  // As the study clips have it, roughly.
  const auto for_error = [](double eps_cm) { return 1.8 * std::pow(eps_cm / 0.5, 1.35); };
  const auto for_ratio = [&](double ratio) { return for_error(0.5 * std::pow(ratio / 130, 1.25)); };
  switch (target.kind) {
    case Target::Kind::Error:
      return for_error(target.value);
    case Target::Kind::MaxError:
      return for_error(target.value / 8);
    case Target::Kind::Ratio:
      return for_ratio(target.value);
    case Target::Kind::Size:
      return for_ratio(static_cast<double>(raw_bytes) / std::max(target.value, 1.0));
    case Target::Kind::CoefficientRatio:
      return for_ratio(2 * target.value);
  }
  return 1;
}

/// One quantisation.
class ClosedLoopRun {
 public:
  ClosedLoopRun(const ClosedLoop& loop, double scale, const Eigen::VectorXd& frame_weights)
      : ClosedLoopRun(loop, frame_weights) {
    coded_.scale = file_scale(scale);
    for (int j = 0; j < channels(); ++j)
      coded_.fineness.push_back(
          std::clamp(static_cast<int>(std::lround(std::log2(loop.mean_curvature_(j)))),
                     kLeastFineness, kMostFineness));
    coded_.values.resize(loop.transform_.per_channel(), channels());
    for (int j = 0; j < channels(); ++j)
      coded_.values.col(j) = quantised(j, loop.transform_.values.col(j));
    begin();
  }

  ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                const Eigen::VectorXd& frame_weights)
      : ClosedLoopRun(loop, frame_weights) {
    coded_ = std::move(coded);
    begin();
  }

  ClosedLoop::Result run(const ClosedLoopWork& work, const Observer<ClosedLoopProgress>& observer) {
    ClosedLoop::Result result;
    rates_.learn(coded_.values);
    if (work.compensate) pass([&](int j) { compensate(j); });
    result.eps_cm = eps_cm();
    while (result.sweeps < work.sweeps && result.complete) {
      rates_.learn(coded_.values);
      pass([&](int j) { sweep(j); });
      ++result.sweeps;
      result.eps_cm = eps_cm();
      result.complete = go_on(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
    }
    result.coded = std::move(coded_);
    return result;
  }

  ClosedLoop::Result coarsen(ErrorBound& bound, const Observer<ClosedLoopProgress>& observer) {
    constexpr double kDearer = 1.5;  // what a bit may cost, from sweep to sweep
    constexpr int kMostSweeps = 24;
    constexpr int kLeastSweeps = 4;
    constexpr double kNear = 0.985;
    constexpr double kLeastGain = 0.01;
    ClosedLoop::Result result;
    bound_ = &bound;
    double bits = total_bits();
    for (bool gains = true; gains && result.sweeps < kMostSweeps && result.complete;) {
      bit_price_ *= kDearer;
      bound.begin(decoded());
      pass([&](int j) { sweep(j); });
      ++result.sweeps;
      result.eps_cm = eps_cm();
      const double before = std::exchange(bits, total_bits());
      gains = result.sweeps < kLeastSweeps || bound.furthest() < kNear ||
              bits < (1 - kLeastGain) * before;
      result.complete = go_on(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
    }
    result.coded = std::move(coded_);
    return result;
  }

 private:
  ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights)
      : loop_(loop),
        bands_(loop.transform_.lifting.bands()),
        frame_weights_(frame_weights),
        rates_(bands_) {
    if (!weighted()) return;
    weighted_curvature_ = frame_weights.asDiagonal() * loop.curvature_;
    weighted_coefficient_curvature_ = loop.coefficient_curvature(weighted_curvature_);
  }

  void begin() {
    errors_ = reconstruct(coded_, loop_.transform_.lifting) - loop_.original_.channels;
    pass([&](int j) { energy_ += errors_.col(j).dot(gradient_); });
  }

  Clip decoded() const {
    return {loop_.original_.sample_rate_hz, loop_.original_.channels + errors_};
  }

  /// By rates learned from the values as they are.
  double total_bits() {
    rates_.learn(coded_.values);
    double bits = 0;
    for (int j = 0; j < channels(); ++j) bits += rates_.bits(coded_.values.col(j).data());
    return bits;
  }

  int channels() const { return loop_.transform_.channels(); }
  double lambda() const { return bit_price_ * coded_.scale * coded_.scale; }  // cm^2 for a bit
  bool weighted() const { return frame_weights_.size() > 0; }
  const Eigen::MatrixXd& curvature() const {
    return weighted() ? weighted_curvature_ : loop_.curvature_;
  }
  const Eigen::MatrixXd& coefficient_curvature() const {
    return weighted() ? weighted_coefficient_curvature_ : loop_.coefficient_curvature_;
  }

  Eigen::VectorXi quantised(int j, const Eigen::VectorXd& coefficients) const {
    const Eigen::ArrayXd steps = coefficients.cwiseProduct(loop_.gains_) / coded_.step(j);
    Eigen::VectorXi values(steps.size());
    for (Eigen::Index c = 0; c < steps.size(); ++c) {
      const double limited = std::clamp<double>(steps(c), -kMostSteps, kMostSteps);
      const auto cut = static_cast<int>(std::abs(limited) + (c < bands_[0].size ? 0.5 : kDeadZone));
      values(c) = limited < 0 ? -cut : cut;
    }
    return values;
  }

  double eps_cm() const {
    return std::sqrt(std::max(energy_, 0.0) / std::max(loop_.original_.frames(), 1));
  }

  /// What `delta` in channel j would add to the sum of squared errors.
  double energy_of(int j, const Eigen::VectorXd& delta) const {
    return delta.dot(2 * gradient_ + curvature().col(j).cwiseProduct(delta));
  }

  /// Visits every channel, from the root to the leaves, with its gradient.
  template <typename Visit>
  void pass(const Visit& visit) {
    if (errors_.rows() == 0) return;  // no frames, no errors
    ErrorSweep sweep(loop_.model_, errors_);
    under_way_ = &sweep;
    for (int j = 0; j < channels(); ++j) {
      gradient_ = sweep.next();
      if (weighted()) gradient_.array() *= frame_weights_.array();
      visit(j);
    }
  }

  /// Moves the channel that is being visited.
  void move(int j, const Eigen::VectorXd& delta) {
    energy_ += energy_of(j, delta);
    errors_.col(j) += delta;
    under_way_->add(delta);
  }

  /// Moves a channel to where it should be, given everyone else's error, if that pays.
  void compensate(int j) {
    constexpr double kDamping = 0.1;
    const auto curve = curvature().col(j).array();
    const double mean = curve.mean();
    Eigen::VectorXd target =
        loop_.original_.channels.col(j).array() -
        (gradient_.array() - curve * errors_.col(j).array()) / (curve + kDamping * mean);
    const std::span<double> samples(target.data(), static_cast<std::size_t>(target.size()));
    loop_.transform_.lifting.forward(samples, samples);
    const Eigen::VectorXi values = quantised(j, target);
    if (values == coded_.values.col(j)) return;
    target = values.cast<double>() * coded_.step(j);
    target.array() /= loop_.gains_.array();
    loop_.transform_.lifting.inverse(samples, samples);
    const Eigen::VectorXd delta = target - loop_.original_.channels.col(j) - errors_.col(j);
    const double saved = rates_.bits(coded_.values.col(j).data()) - rates_.bits(values.data());
    if (energy_of(j, delta) >= lambda() * saved) return;
    coded_.values.col(j) = values;
    move(j, delta);
  }

  /// Moves each coefficient of a channel to the cheapest of the values around its best one.
  void sweep(int j) {
    // A zero that needs less than half a step stays one; moves of its neighbours change that
    // little.
    constexpr double kPromising = 0.4;
    Eigen::VectorXd gradient = gradient_;
    Eigen::VectorXd delta = Eigen::VectorXd::Zero(gradient.size());
    int* const values = coded_.values.col(j).data();
    const double channel_step = coded_.step(j);
    count_alive(values);
    if (bound_) bound_->next();
    Eigen::VectorXd slopes(gradient.size());
    loop_.transform_.lifting.correlate(
        std::span(gradient.data(), static_cast<std::size_t>(gradient.size())),
        std::span(slopes.data(), static_cast<std::size_t>(slopes.size())));
    for (int b = 0; b < static_cast<int>(bands_.size()); ++b)
      for (int i = 0; i < bands_[static_cast<std::size_t>(b)].size; ++i) {
        const int c = bands_[static_cast<std::size_t>(b)].first + i;
        const double curve = coefficient_curvature()(c, j);
        const double step = channel_step / loop_.gains_(c);
        if (values[c] == 0 && std::abs(slopes(c)) < kPromising * curve * step) continue;
        const SynthesisFunction function = loop_.synthesis_[c];
        const auto size = function.values.size();
        const double slope = function.values.dot(gradient.segment(function.first, size));
        const int moved = best_move(values, b, i, slope * step, curve * step * step);
        if (moved == 0) continue;
        const Eigen::VectorXd change = moved * step * function.values;
        if (bound_ && !bound_->allows(function.first, change)) continue;
        if (bound_) bound_->add(function.first, change);
        alive_[static_cast<std::size_t>(b)] += (values[c] + moved != 0) - (values[c] != 0);
        values[c] += moved;
        delta.segment(function.first, size) += change;
        gradient.segment(function.first, size) +=
            change.cwiseProduct(curvature().col(j).segment(function.first, size));
      }
    if (!delta.isZero(0)) move(j, delta);
  }

  void count_alive(const int* values) {
    alive_.clear();
    for (const Band& band : bands_)
      alive_.push_back(static_cast<int>(
          band.size - std::count(values + band.first, values + band.first + band.size, 0)));
  }

  /// By how many steps to move a coefficient; a move of x costs 2 slope x + curve x^2 in error.
  int best_move(int* values, int b, int i, double slope, double curve) const {
    const int now = values[bands_[static_cast<std::size_t>(b)].first + i];
    if (now == 0 && std::abs(slope) <= 0.5 * curve) return 0;
    const double best = now - slope / curve;
    if (!(std::abs(best) < kMostSteps)) return 0;
    const auto nearest = static_cast<int>(std::lround(best));
    const int smaller = nearest - (nearest > 0) + (nearest < 0);
    const double bits_now = bits_with(values, b, i, now);
    int move = 0;
    double least = 0;
    for (const int value : {nearest, smaller}) {
      if (value == now) continue;
      const double x = value - now;
      const double cost =
          x * (2 * slope + x * curve) + lambda() * (bits_with(values, b, i, value) - bits_now);
      if (cost >= least) continue;
      least = cost;
      move = value - now;
    }
    return move;
  }

  /// The bits that depend on a coefficient, were it `value`.
  double bits_with(int* values, int b, int i, int value) const {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    if (b == 0)
      return RateTable::coarse_bits(value - (i > 0 ? values[i - 1] : 0)) +
             (i + 1 < band.size ? RateTable::coarse_bits(values[i + 1] - value) : 0);
    // A band that is zero throughout takes next to nothing.
    const bool was_something = values[band.first + i] != 0;
    const bool others = alive_[static_cast<std::size_t>(b)] > (was_something ? 1 : 0);
    const double waking = others || value == 0 ? 0 : 4 + 0.05 * band.size;
    return waking + rates_.bits_around(values, b, i, value);
  }

  const ClosedLoop& loop_;
  const std::vector<Band>& bands_;
  const Eigen::VectorXd& frame_weights_;
  Eigen::MatrixXd weighted_curvature_;
  Eigen::MatrixXd weighted_coefficient_curvature_;
  RateTable rates_;
  QuantisedSignals coded_;
  Eigen::MatrixXd errors_;           // frames x channels: decoded minus original
  double energy_ = 0;                // the sum of squared errors that makes, frames weighted
  ErrorBound* bound_ = nullptr;      // that must hold, if any
  ErrorSweep* under_way_ = nullptr;  // the pass under way
  Eigen::VectorXd gradient_;         // where it is, frames weighted
  double bit_price_ = kBitPrice;     // squared steps
  std::vector<int> alive_;  // how many of each band are not zero, of the channel being swept
};

ClosedLoop::Result ClosedLoop::quantise(double scale, const ClosedLoopWork& work,
                                        const Eigen::VectorXd& frame_weights,
                                        const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, scale, frame_weights).run(work, observer);
}

ClosedLoop::Result ClosedLoop::coarsen(QuantisedSignals coded, ErrorBound& bound,
                                       const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, std::move(coded), {}).coarsen(bound, observer);
}

}  // namespace mocapress
