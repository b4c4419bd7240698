// SPDX-License-Identifier: MIT
// Based on: D. Needell and J. A. Tropp, "CoSaMP: iterative signal recovery from incomplete and
// inaccurate samples", 2009: choose, fit, choose anew.
#include "core/codec/difference_fit.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"
#include "core/wavelet/synthesis.h"

namespace mocapress {
namespace {

std::span<double> span_of(Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

/// One signal, all of whose coefficients are kept at first.
class SignalFit {
 public:
  SignalFit(const Lifting& lifting, const Synthesis& synthesis, const Eigen::VectorXd& signal,
            const FitWeights& weights)
      : lifting_(lifting), weights_(weights), values_(signal) {
    slopes_ = slopes_of(signal);
    curvature_.resize(signal.size());
    for (int c = 0; c < static_cast<int>(signal.size()); ++c) curvature_(c) = cost_of(synthesis[c]);
    energy_ = signal.dot(weigh(signal));
    lifting.forward(span_of(values_), span_of(values_));
    residual_ = Eigen::VectorXd::Zero(signal.size());
  }

  /// What is saved by keeping each coefficient, if it were alone.
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

  const Eigen::VectorXd& values() const { return values_; }
  double cost() const { return energy_ - values_.dot(slopes_ + residual_); }

 private:
  /// M d.
  Eigen::VectorXd weigh(const Eigen::VectorXd& signal) const {
    Eigen::VectorXd weighted = weights_.place.cwiseProduct(signal);
    const Eigen::Index last = signal.size() - 1;
    if (last < 1) return weighted;
    const Eigen::VectorXd steps =
        weights_.step.tail(last).cwiseProduct(signal.tail(last) - signal.head(last));
    weighted.tail(last) += steps;
    weighted.head(last) -= steps;
    return weighted;
  }

  Eigen::VectorXd slopes_of(const Eigen::VectorXd& signal) const {
    Eigen::VectorXd weighted = weigh(signal);
    lifting_.correlate(span_of(weighted), span_of(weighted));
    return weighted;
  }

  /// A^T M A v, with A the inverse transform.
  Eigen::VectorXd normal(Eigen::VectorXd values) const {
    lifting_.inverse(span_of(values), span_of(values));
    return slopes_of(values);
  }

  double cost_of(const SynthesisFunction& function) const {
    const auto size = function.values.size();
    double cost = function.values.cwiseAbs2().dot(weights_.place.segment(function.first, size));
    double before = 0;
    for (Eigen::Index i = 0; i <= size && function.first + i < weights_.step.size(); ++i) {
      const double now = i < size ? function.values(i) : 0;
      if (function.first + i > 0)
        cost += weights_.step(function.first + i) * (now - before) * (now - before);
      before = now;
    }
    return cost;
  }

  const Lifting& lifting_;
  const FitWeights& weights_;
  double energy_ = 0;
  Eigen::VectorXd slopes_;     // A^T M d
  Eigen::VectorXd curvature_;  // the diagonal of A^T M A
  Eigen::VectorXd values_;
  Eigen::VectorXd residual_;  // A^T M (d - A v)
};

/// Where the `count` largest are, as ones.
Eigen::ArrayXXd largest(const Eigen::ArrayXXd& worth, int count) {
  Eigen::ArrayXXd mask = Eigen::ArrayXXd::Zero(worth.rows(), worth.cols());
  std::vector<Eigen::Index> order(static_cast<std::size_t>(worth.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto end = order.begin() + std::min<std::ptrdiff_t>(count, std::ssize(order));
  std::partial_sort(order.begin(), end, order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return worth(a) != worth(b) ? worth(a) > worth(b) : a < b;
  });
  for (auto i = order.begin(); i != end; ++i) mask(*i) = 1;
  return mask;
}

}  // namespace

CoefficientFit fit_coefficients(const Clip& columns, const std::vector<FitWeights>& weights,
                                Basis basis, int count) {
  constexpr int kRounds = 8;
  const Lifting lifting(basis, columns.frames());
  const Synthesis synthesis(lifting);
  std::vector<SignalFit> fits;
  for (Eigen::Index s = 0; s < columns.channels.cols(); ++s)
    fits.emplace_back(lifting, synthesis, columns.channels.col(s),
                      weights[static_cast<std::size_t>(s)]);

  Eigen::ArrayXXd worth(columns.channels.rows(), columns.channels.cols());
  Eigen::ArrayXXd alone = worth;
  Eigen::ArrayXXd kept = Eigen::ArrayXXd::Zero(worth.rows(), worth.cols());
  CoefficientFit best{.ranked = {lifting, {}, {}, {}}, .kept = {}};
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < kRounds; ++round) {
    for (Eigen::Index s = 0; s < worth.cols(); ++s)
      worth.col(s) = fits[static_cast<std::size_t>(s)].worth();
    const Eigen::ArrayXXd chosen = largest(worth, count);
    if (round > 0 && (chosen == kept).all()) break;
    kept = chosen;
    parallel_for(Eigen::Index{0}, worth.cols(),
                 [&](Eigen::Index s) { fits[static_cast<std::size_t>(s)].keep(kept.col(s)); });
    double cost = 0;
    for (const SignalFit& fit : fits) cost += fit.cost();
    if (cost >= least) continue;
    least = cost;
    best.kept.clear();
    best.ranked.values.resize(worth.rows(), worth.cols());
    best.ranked.importance.resize(worth.rows(), worth.cols());
    best.ranked.by_importance.clear();
    for (Eigen::Index s = 0; s < worth.cols(); ++s) {
      const SignalFit& fit = fits[static_cast<std::size_t>(s)];
      const Eigen::ArrayXd mask = kept.col(s);
      best.ranked.values.col(s) = (mask > 0).select(fit.values().array(), fit.best_alone());
      best.ranked.importance.col(s) = fit.worth().sqrt();
      best.kept.push_back(static_cast<int>(mask.sum()));
      auto& order = best.ranked.by_importance.emplace_back(static_cast<std::size_t>(worth.rows()));
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](int a, int b) {
        if (mask(a) != mask(b)) return mask(a) > mask(b);
        const double x = best.ranked.importance(a, s);
        const double y = best.ranked.importance(b, s);
        return x != y ? x > y : a < b;
      });
    }
  }
  return best;
}

}  // namespace mocapress
