// SPDX-License-Identifier: MIT
// Based on: D. Needell and J. A. Tropp, "CoSaMP: iterative signal recovery from incomplete and
// inaccurate samples", 2009: choose, fit, choose anew.
#include "core/codec/encode/mend/difference_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/parallel.h"
#include "core/codec/format/quantised_signals.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {
namespace {

std::span<double> span_of(Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// One signal d, whose error e costs e^T M e by its FitWeights. A is the inverse transform, v are
/// the coefficients. All coefficients are kept at first.
class SignalFit {
 public:
  SignalFit(const Lifting& lifting, const Synthesis& synthesis, const Eigen::VectorXd& signal,
            const FitWeights& weights)
      : lifting_(&lifting), weights_(&weights), values_(signal) {
    slopes_ = slopes_of(signal);
    curvature_.resize(signal.size());
    for (int c = 0; c < static_cast<int>(signal.size()); ++c) curvature_(c) = cost_of(synthesis[c]);
    energy_ = signal.dot(weigh(signal));
    lifting.forward(span_of(values_), span_of(values_));
    residual_ = Eigen::VectorXd::Zero(signal.size());
  }

  /// The cost that each coefficient saves with its best value instead of zero, if all others stay
  /// as they are.
  Eigen::ArrayXd worth() const { return best_alone().square() * curvature_.array(); }
  Eigen::ArrayXd best_alone() const {
    return values_.array() + residual_.array() / curvature_.array();
  }

  /// Keeps the coefficients where `mask` is 1 and fits them by conjugate gradients.
  void keep(const Eigen::ArrayXd& mask) {
    constexpr int kMostSteps = 30;
    constexpr double kExact = 1e-8;
    values_.array() *= mask;
    residual_ = slopes_ - normal(values_);
    Eigen::VectorXd open = residual_.array() * mask;
    Eigen::VectorXd direction = open.array() / curvature_.array();
    double progress = open.dot(direction);
    const double enough = kExact * progress;
    for (int i = 0; i < kMostSteps && progress > enough; ++i) {
      const Eigen::VectorXd moved = normal(direction);
      const double step = progress / direction.dot(moved);
      values_ += step * direction;
      residual_ -= step * moved;
      open = residual_.array() * mask;
      const Eigen::VectorXd eased = open.array() / curvature_.array();
      const double next = open.dot(eased);
      direction = eased + next / progress * direction;
      progress = next;
    }
  }

  /// Rounds to whole steps: first to the nearest, then each to its best value given the others.
  Eigen::VectorXi rounded(double step, const Eigen::ArrayX<bool>& mask,
                          const std::vector<double>& gains, const Synthesis& synthesis) const {
    constexpr int kMostSweeps = 20;
    Eigen::VectorXi steps = Eigen::VectorXi::Zero(values_.size());
    Eigen::VectorXd missing = values_;  // fitted minus rounded values
    const auto size_of = [&](Eigen::Index c) { return step / gains[c]; };
    for (Eigen::Index c = 0; c < values_.size(); ++c) {
      if (!mask(c)) continue;
      steps(c) = whole(values_(c) / size_of(c));
      missing(c) -= steps(c) * size_of(c);
    }
    lifting_->inverse(span_of(missing), span_of(missing));
    missing = weigh(missing);
    bool moved = true;
    for (int sweep = 0; sweep < kMostSweeps && moved; ++sweep) {
      moved = false;
      for (Eigen::Index c = 0; c < values_.size(); ++c) {
        if (!mask(c)) continue;
        const SynthesisFunction function = synthesis[static_cast<int>(c)];
        const double slope =
            function.values.dot(missing.segment(function.first, function.values.size()));
        const int better = whole(steps(c) + (slope + residual_(c)) / curvature_(c) / size_of(c));
        if (better == steps(c)) continue;
        subtract((better - steps(c)) * size_of(c), function, missing);
        steps(c) = better;
        moved = true;
      }
    }
    return steps;
  }

  const Eigen::VectorXd& curvature() const { return curvature_; }
  double cost() const { return energy_ - values_.dot(slopes_ + residual_); }

 private:
  static int whole(double steps) {
    return static_cast<int>(std::lround(std::clamp<double>(steps, -kMostSteps, kMostSteps)));
  }

  /// Subtracts M times `amount` of a synthesis function from `weighted`.
  void subtract(double amount, const SynthesisFunction& function, Eigen::VectorXd& weighted) const {
    const Eigen::Index first = function.first;
    const Eigen::Index size = function.values.size();
    weighted.segment(first, size) -=
        amount * weights_->place.segment(first, size).cwiseProduct(function.values);
    double before = 0;
    for (Eigen::Index i = 0; i <= size && first + i < weighted.size(); ++i) {
      const double now = i < size ? function.values(i) : 0;
      const double step = amount * weights_->step(first + i) * (now - before);
      before = now;
      if (first + i == 0) continue;
      weighted(first + i) -= step;
      weighted(first + i - 1) += step;
    }
  }

  /// M d.
  Eigen::VectorXd weigh(const Eigen::VectorXd& signal) const {
    Eigen::VectorXd weighted = weights_->place.cwiseProduct(signal);
    const Eigen::Index last = signal.size() - 1;
    if (last < 1) return weighted;
    const Eigen::VectorXd steps =
        weights_->step.tail(last).cwiseProduct(signal.tail(last) - signal.head(last));
    weighted.tail(last) += steps;
    weighted.head(last) -= steps;
    return weighted;
  }

  Eigen::VectorXd slopes_of(const Eigen::VectorXd& signal) const {
    Eigen::VectorXd weighted = weigh(signal);
    lifting_->correlate(span_of(weighted), span_of(weighted));
    return weighted;
  }

  /// A^T M A v, with A the inverse transform.
  Eigen::VectorXd normal(Eigen::VectorXd values) const {
    lifting_->inverse(span_of(values), span_of(values));
    return slopes_of(values);
  }

  double cost_of(const SynthesisFunction& function) const {
    const auto size = function.values.size();
    double cost = function.values.cwiseAbs2().dot(weights_->place.segment(function.first, size));
    double before = 0;
    for (Eigen::Index i = 0; i <= size && function.first + i < weights_->step.size(); ++i) {
      const double now = i < size ? function.values(i) : 0;
      if (function.first + i > 0)
        cost += weights_->step(function.first + i) * (now - before) * (now - before);
      before = now;
    }
    return cost;
  }

  const Lifting* lifting_;
  const FitWeights* weights_;
  double energy_ = 0;
  Eigen::VectorXd slopes_;     // A^T M d
  Eigen::VectorXd curvature_;  // the diagonal of A^T M A
  Eigen::VectorXd values_;
  Eigen::VectorXd residual_;  // A^T M (d - A v)
};

/// Marks the `count` largest entries.
Eigen::ArrayXX<bool> largest(const Eigen::ArrayXXd& worth, int count) {
  Eigen::ArrayXX<bool> mask = Eigen::ArrayXX<bool>::Constant(worth.rows(), worth.cols(), false);
  std::vector<Eigen::Index> order(worth.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto end = order.begin() + std::min<std::ptrdiff_t>(count, std::ssize(order));
  std::partial_sort(order.begin(), end, order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return worth(a) != worth(b) ? worth(a) > worth(b) : a < b;
  });
  for (auto i = order.begin(); i != end; ++i) mask(*i) = true;
  return mask;
}

// Limit of the mean cost of rounding a coefficient, as a share of what the best dropped coefficient
// would save.
constexpr double kShareOfDropped = 0.1;
constexpr double kLeastDropped = 1e-6;  // squared cm: nothing to be seen

/// Mean cost of rounding a kept coefficient to `step`, in units of step^2 / 12.
double rounding_cost(const Eigen::VectorXd& curvature, const Eigen::ArrayX<bool>& mask,
                     const std::vector<double>& gains) {
  double sum = 0;
  double kept = 0;
  for (Eigen::Index c = 0; c < curvature.size(); ++c) {
    if (!mask(c)) continue;
    const double gain = gains[c];
    sum += curvature(c) / (gain * gain);
    ++kept;
  }
  return kept > 0 ? sum / kept : 1;
}

}  // namespace

DifferenceFit fit_differences(const Clip& columns, const std::vector<FitWeights>& weights,
                              Basis basis, int count, const CodedStep& coded_step) {
  constexpr int kRounds = 8;
  const Eigen::Index frames = columns.channels.rows();
  const Eigen::Index signals = columns.channels.cols();
  const Lifting lifting(basis, columns.frames());
  const Synthesis synthesis(lifting);
  std::vector<SignalFit> fits;
  for (Eigen::Index s = 0; s < signals; ++s)
    fits.emplace_back(lifting, synthesis, columns.channels.col(s), weights[s]);

  Eigen::ArrayXXd worth(frames, signals);
  Eigen::ArrayXX<bool> kept = Eigen::ArrayXX<bool>::Constant(frames, signals, false);
  std::vector<SignalFit> best = fits;
  double least = std::numeric_limits<double>::infinity();
  double threshold = 0;  // the cost that the best dropped coefficient would save
  DifferenceFit found;
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index s = 0; s < signals; ++s) worth.col(s) = fits[s].worth();
    const Eigen::ArrayXX<bool> chosen = largest(worth, count);
    if (round > 0 && (chosen == kept).all()) break;
    kept = chosen;
    parallel_for(Eigen::Index{0}, signals,
                 [&](Eigen::Index s) { fits[s].keep(kept.col(s).cast<double>()); });
    double cost = 0;
    for (const SignalFit& fit : fits) cost += fit.cost();
    if (cost >= least) continue;
    least = cost;
    found.kept = kept;
    best = fits;
  }
  for (Eigen::Index s = 0; s < signals; ++s) {
    const Eigen::ArrayXd dropped = found.kept.col(s).select(0, best[s].worth());
    if (frames > 0) threshold = std::max(threshold, dropped.maxCoeff());
  }

  const std::vector<double> gains = lifting.gains();
  found.steps.resize(signals);
  found.values.resize(frames, signals);
  for (Eigen::Index s = 0; s < signals; ++s) {
    const SignalFit& fit = best[s];
    const double cost = rounding_cost(fit.curvature(), found.kept.col(s), gains) / 12;
    found.steps(s) =
        coded_step(std::sqrt(kShareOfDropped * std::max(threshold, kLeastDropped) / cost));
  }
  parallel_for(Eigen::Index{0}, signals, [&](Eigen::Index s) {
    found.values.col(s) = best[s].rounded(found.steps(s), found.kept.col(s), gains, synthesis);
  });
  return found;
}

}  // namespace mocapress
