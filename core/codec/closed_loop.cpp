// SPDX-License-Identifier: MIT
#include "core/codec/closed_loop.h"

#include <algorithm>
#include <cmath>

#include "core/codec/coefficient_model.h"

namespace mocapress {
namespace {

constexpr int kSymbols = 16;

/// What a coefficient costs, in bits, by its neighbours.
class Rate {
 public:
  explicit Rate(const std::vector<Band>& bands) : bands_(bands) {
    bits_.assign(kContexts * kSymbols, 0);
  }

  struct Spot {
    int first, size, index, parent_first, parent_size, level;
  };

  int context(const int* q, int b, int i) const {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    const int* own = q + band.first;
    const int a = 2 * (i > 0 ? std::abs(own[i - 1]) : 0) + (i > 1 ? std::abs(own[i - 2]) : 0);
    int p = 0;
    if (b > 1) {
      const Band& up = bands_[static_cast<std::size_t>(b - 1)];
      const int* par = q + up.first;
      const int k = i >> 1, l = i % 2 ? k + 1 : k - 1;
      p = 2 * (k < up.size ? std::abs(par[k]) : 0) + (l >= 0 && l < up.size ? std::abs(par[l]) : 0);
    }
    const int level = std::min(static_cast<int>(bands_.size()) - 1 - b, kLevels - 1);
    return (level * kSizes + size_of(a)) * kSizes + size_of(p);
  }
  double of(int context, int value) const {
    const int m = std::abs(value);
    const double* const row = bits_.data() + context * kSymbols;
    if (m < kSymbols - 1) return row[m];
    return row[kSymbols - 1] + 2 * std::log2(m - kSymbols + 2.0);
  }
  static double coarse(int difference) { return 2 * std::log2(1.0 + 2 * std::abs(difference)) + 1; }

  void learn(const Eigen::MatrixXi& values) {
    std::vector<double> counts(static_cast<std::size_t>(kContexts * kSymbols), 0);
    std::vector<double> level_counts(static_cast<std::size_t>(kLevels * kSizes * kSymbols), 0);
    for (int s = 0; s < values.cols(); ++s) {
      const int* q = values.col(s).data();
      for (int b = 1; b < static_cast<int>(bands_.size()); ++b) {
        const Band& band = bands_[static_cast<std::size_t>(b)];
        if (std::all_of(q + band.first, q + band.first + band.size, [](int v) { return v == 0; }))
          continue;
        for (int i = 0; i < band.size; ++i)
          counts[static_cast<std::size_t>(context(q, b, i) * kSymbols +
                                          std::min(std::abs(q[band.first + i]), kSymbols - 1))] +=
              1;
      }
    }
    // Contexts seen little fall back on a geometric law.
    for (int c = 0; c < kContexts; ++c) {
      const int a = c / kSizes % kSizes, p = c % kSizes;
      const double mean = 0.02 + 0.2 * a + 0.15 * p;
      const double r = mean / (1 + mean);
      double total = 0;
      std::array<double, kSymbols> row;
      for (int k = 0; k < kSymbols; ++k) {
        row[k] = counts[static_cast<std::size_t>(c * kSymbols + k)] + 4 * (1 - r) * std::pow(r, k) +
                 0.002;
        total += row[k];
      }
      for (int k = 0; k < kSymbols; ++k)
        bits_[static_cast<std::size_t>(c * kSymbols + k)] = -std::log2(row[k] / total) + (k > 0);
    }
  }

 private:
  static constexpr int kContexts = kLevels * kSizes * kSizes;
  const std::vector<Band>& bands_;
  std::vector<double> bits_;
};

}  // namespace

ClosedLoop::ClosedLoop(const RankedCoefficients& transform, const Clip& original,
                       const ErrorModel& model)
    : transform_(transform),
      original_(original),
      model_(model),
      synthesis_(transform.lifting),
      gains_(transform.lifting.gains()),
      curvature_(model.curvature()) {
  const int channels = transform.channels();
  // What moves no landmark is still to be somewhere.
  const double least = curvature_.size() == 0 ? 1 : std::max(1e-4 * curvature_.mean(), 1e-12);
  curvature_ = curvature_.cwiseMax(least);
  coefficient_curvature_.resize(transform.per_channel(), channels);
  mean_curvature_ = curvature_.colwise().mean();
  for (int j = 0; j < channels; ++j)
    for (int c = 0; c < transform.per_channel(); ++c) {
      const SynthesisFunction phi = synthesis_[c];
      coefficient_curvature_(c, j) =
          (phi.values.array().square() *
           curvature_.col(j).segment(phi.first, phi.values.size()).array())
              .sum();
    }
}

class ClosedLoopRun {
 public:
  ClosedLoopRun(const ClosedLoop& loop, double scale, const ClosedLoopEffort& effort)
      : loop_(loop),
        effort_(effort),
        bands_(loop.transform_.lifting.bands()),
        rate_(bands_),
        state_(loop.model_) {
    const int channels = loop.transform_.channels();
    const int n = loop.transform_.per_channel();
    out_.scale = file_scale(scale);
    lambda_ = effort.lambda * out_.scale * out_.scale;
    out_.values.resize(n, channels);
    errors_.resize(n, channels);
    for (int j = 0; j < channels; ++j) {
      const double d = loop.mean_curvature_(j);
      out_.fineness.push_back(static_cast<int>(std::lround(std::log2(d))));
    }
    for (int j = 0; j < channels; ++j)
      quantise_channel(j, loop.transform_.values.col(j), out_.values.col(j));
  }

  ClosedLoop::Result run(const Observer<ClosedLoopProgress>& observer) {
    const int channels = loop_.transform_.channels();
    for (int j = 0; j < channels; ++j) {
      errors_.col(j) = synth(j, out_.values.col(j)) - loop_.original_.channels.col(j);
      state_.add(j, errors_.col(j));
    }
    for (int k = 0; k < effort_.compensations; ++k) {
      rate_.learn(out_.values);
      for (int j = 0; j < channels; ++j) compensate(j, k == 0 ? 1.0 : 0.5);
    }
    ClosedLoop::Result result;
    for (int k = 0; k < effort_.sweeps && result.complete; ++k) {
      rate_.learn(out_.values);
      for (int j = 0; j < channels; ++j) sweep(j);
      ++result.sweeps;
      result.eps_cm = std::sqrt(std::max(state_.squared_eps(), 0.0));
      result.complete = go_on(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
    }
    result.coded = std::move(out_);
    return result;
  }

 private:
  double step(int j, int c) const {
    return out_.step(j) / loop_.gains_[static_cast<std::size_t>(c)];
  }

  template <typename In, typename Out>
  void quantise_channel(int j, const In& coefficients, Out&& q) const {
    const double s = out_.step(j);
    for (int c = 0; c < coefficients.size(); ++c) {
      const double v = coefficients(c) * loop_.gains_[static_cast<std::size_t>(c)] / s;
      if (c < bands_[0].size)
        q(c) = static_cast<int>(std::lround(v));
      else {
        const int m = static_cast<int>(std::abs(v) + effort_.dead_zone);
        q(c) = v < 0 ? -m : m;
      }
    }
  }
  template <typename In>
  Eigen::VectorXd synth(int j, const In& q) const {
    Eigen::VectorXd v(q.size());
    const double s = out_.step(j);
    for (int c = 0; c < q.size(); ++c) v(c) = q(c) * s / loop_.gains_[static_cast<std::size_t>(c)];
    const std::span<double> span(v.data(), static_cast<std::size_t>(v.size()));
    loop_.transform_.lifting.inverse(span, span);
    return v;
  }

  double channel_bits(const Eigen::VectorXi& q) const {
    double bits = 0;
    int before = 0;
    for (int i = 0; i < bands_[0].size; ++i) {
      bits += Rate::coarse(q(i) - before);
      before = q(i);
    }
    for (int b = 1; b < static_cast<int>(bands_.size()); ++b) {
      const Band& band = bands_[static_cast<std::size_t>(b)];
      if ((q.segment(band.first, band.size).array() == 0).all()) continue;
      for (int i = 0; i < band.size; ++i)
        bits += rate_.of(rate_.context(q.data(), b, i), q(band.first + i));
    }
    return bits;
  }

  void compensate(int j, double a) {
    const auto d = loop_.curvature_.col(j).array();
    const auto g = state_.gradient().col(j).array();
    const auto e = errors_.col(j).array();
    Eigen::VectorXd target = loop_.original_.channels.col(j).array() -
                             a * (g - d * e) / (d + 0.1 * loop_.mean_curvature_(j));
    const std::span<double> span(target.data(), static_cast<std::size_t>(target.size()));
    loop_.transform_.lifting.forward(span, span);
    Eigen::VectorXi q(target.size());
    quantise_channel(j, target, q);
    const Eigen::VectorXi now = out_.values.col(j);
    if (q == now) return;
    const Eigen::VectorXd error = synth(j, q) - loop_.original_.channels.col(j);
    const Eigen::VectorXd delta = error - errors_.col(j);
    const double energy = static_cast<double>(delta.size()) * state_.change(j, delta);
    if (energy + lambda_ * (channel_bits(q) - channel_bits(now)) >= 0) return;
    out_.values.col(j) = q;
    errors_.col(j) = error;
    state_.add(j, delta);
  }

  /// The bits of coefficient i and of those it is a neighbour of.
  double local_bits(int* q, int b, int i, int value) const {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    int& mine = q[band.first + i];
    const int kept = mine;
    mine = value;
    double bits = rate_.of(rate_.context(q, b, i), value);
    for (int k = i + 1; k <= i + 2 && k < band.size; ++k)
      bits += rate_.of(rate_.context(q, b, k), q[band.first + k]);
    if (b + 1 < static_cast<int>(bands_.size())) {
      const Band& below = bands_[static_cast<std::size_t>(b + 1)];
      if (alive_[static_cast<std::size_t>(b + 1)] != 0)
        for (int k = std::max(2 * i - 1, 0); k <= 2 * i + 2 && k < below.size; ++k)
          bits += rate_.of(rate_.context(q, b + 1, k), q[below.first + k]);
    }
    mine = kept;
    return bits;
  }

  void sweep(int j) {
    Eigen::VectorXd g = state_.gradient().col(j);
    const auto d = loop_.curvature_.col(j);
    int* const q = out_.values.col(j).data();
    Eigen::VectorXd delta = Eigen::VectorXd::Zero(g.size());
    bool changed = false;
    alive_.assign(bands_.size(), 0);
    for (std::size_t b = 0; b < bands_.size(); ++b)
      for (int i = 0; i < bands_[b].size; ++i) alive_[b] += q[bands_[b].first + i] != 0;
    for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
      const Band& band = bands_[static_cast<std::size_t>(b)];
      for (int i = 0; i < band.size; ++i) {
        const int c = band.first + i;
        const SynthesisFunction phi = loop_.synthesis_[c];
        const auto size = phi.values.size();
        const double inner = phi.values.dot(g.segment(phi.first, size));
        const double h = loop_.coefficient_curvature_(c, j);
        const double s = step(j, c);
        const int now = q[c];
        if (now == 0 && std::abs(inner) <= 0.5 * s * h) continue;
        const double best_real = now - inner / (h * s);
        if (!(std::abs(best_real) < kMostSteps)) continue;
        const int nearest = static_cast<int>(std::lround(best_real));
        const int toward = nearest > 0 ? nearest - 1 : nearest < 0 ? nearest + 1 : 0;
        int best = now;
        double least = 0;
        const auto bits = [&](int v) {
          if (b == 0) {
            const int before = i > 0 ? q[c - 1] : 0;
            return Rate::coarse(v - before) +
                   (i + 1 < band.size ? Rate::coarse(q[c + 1] - v) : 0.0);
          }
          return local_bits(q, b, i, v);
        };
        const double bits_now = bits(now);
        int tried = 0;
        std::array<int, 3> candidates{};
        for (const int v : {nearest, toward, 0})
          if (v != now && std::find(candidates.begin(), candidates.begin() + tried, v) ==
                              candidates.begin() + tried)
            candidates[static_cast<std::size_t>(tried++)] = v;
        for (int k = 0; k < tried; ++k) {
          const int v = candidates[static_cast<std::size_t>(k)];
          const double dx = (v - now) * s;
          double price = bits(v) - bits_now;
          if (b > 0 && alive_[static_cast<std::size_t>(b)] == 0) price += 4 + 0.05 * band.size;
          if (b > 0 && v == 0 && alive_[static_cast<std::size_t>(b)] == 1)
            price -= 4 + 0.05 * band.size;
          const double cost = dx * (2 * inner + dx * h) + lambda_ * price;
          if (cost < least) {
            least = cost;
            best = v;
          }
        }
        if (best == now) continue;
        alive_[static_cast<std::size_t>(b)] += (best != 0) - (now != 0);
        q[c] = best;
        const double dx = (best - now) * s;
        delta.segment(phi.first, size) += dx * phi.values;
        g.segment(phi.first, size).array() +=
            dx * phi.values.array() * d.segment(phi.first, size).array();
        changed = true;
      }
    }
    if (!changed) return;
    errors_.col(j) += delta;
    state_.add(j, delta);
  }

  const ClosedLoop& loop_;
  ClosedLoopEffort effort_;
  const std::vector<Band>& bands_;
  Rate rate_;
  ErrorState state_;
  QuantisedSignals out_;
  Eigen::MatrixXd errors_;
  double lambda_ = 0;
  std::vector<int> alive_;
};

ClosedLoop::Result ClosedLoop::quantise(double scale, const ClosedLoopEffort& effort,
                                        const Observer<ClosedLoopProgress>& observer) const {
  return ClosedLoopRun(*this, scale, effort).run(observer);
}

double ClosedLoop::finest_scale() const {
  const Eigen::Map<const Eigen::VectorXd> gain(gains_.data(), std::ssize(gains_));
  double largest = 1e-6;
  for (int j = 0; j < transform_.channels(); ++j)
    largest =
        std::max(largest, (gain.asDiagonal() * transform_.values.col(j)).cwiseAbs().maxCoeff() *
                              std::sqrt(mean_curvature_(j)));
  return largest / (kMostSteps / 16);
}

double ClosedLoop::likely_scale(const Target& target) const {
  switch (target.kind) {
    case Target::Kind::Error:
      return 2 * target.value;
    case Target::Kind::MaxError:
      return 0.4 * target.value;
    case Target::Kind::Ratio:
      return 0.01 * target.value;
    case Target::Kind::Size:
      return 0.01 * 4 * static_cast<double>(original_.channels.size()) /
             std::max(target.value, 1.0);
    case Target::Kind::CoefficientRatio:
      break;
  }
  return 1;
}

}  // namespace mocapress
