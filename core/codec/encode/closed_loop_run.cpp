// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop_run.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mocapress {

namespace {

constexpr double kDeadZone = 0.25;  // what is added before details are cut to whole steps

/// Steps shrink with what a channel moves, squared, to half this power. One would give all channels
/// the same share of the error; on corpus/train this takes the fewest bytes (ADAPTIVE.md).
constexpr double kStepPower = 0.9;

// Squared steps of error that a bit is worth, in the first sweep and in the last.
constexpr double kFirstBitPrice = 0.054;
constexpr double kLastBitPrice = 0.041;

double price_of(int sweep, int sweeps) {
  return kFirstBitPrice + (kLastBitPrice - kFirstBitPrice) * sweep / std::max(sweeps - 1, 1);
}

/// How much dearer a bit must be for a sweep that makes eps_x grow by that logarithm: about, as
/// clips from 0.2 to 0.6 cm have it.
double dearer_for(double growth) {
  constexpr double kMost = 0.7;
  constexpr double kSlope = 0.035;   // of less error
  constexpr double kLinear = 0.018;  // of more
  constexpr double kSquare = 0.055;
  const double log_price =
      growth < 0 ? growth / kSlope
                 : (std::sqrt(kLinear * kLinear + 4 * kSquare * growth) - kLinear) / (2 * kSquare);
  return std::exp(std::clamp(log_price, -kMost, kMost));
}

}  // namespace

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights)
    : loop_(loop),
      bands_(loop.transform_.lifting.bands()),
      frame_weights_(frame_weights),
      rates_(bands_),
      bit_price_(kFirstBitPrice) {
  if (!weighted()) return;
  weighted_curvature_ = frame_weights.asDiagonal() * loop.curvature_;
  weighted_coefficient_curvature_ = loop.coefficient_curvature(weighted_curvature_);
}

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, double scale,
                             const Eigen::VectorXd& frame_weights)
    : ClosedLoopRun(loop, frame_weights) {
  coded_.scale = file_scale(scale);
  for (int j = 0; j < channels(); ++j)
    coded_.step_exponent.push_back(
        std::clamp(static_cast<int>(std::lround(kStepPower * std::log2(loop.mean_curvature_(j)))),
                   kLeastStepExponent, kMostStepExponent));
  coded_.values.resize(loop.transform_.per_channel(), channels());
  for (int j = 0; j < channels(); ++j)
    coded_.values.col(j) = quantised(j, loop.transform_.values.col(j));
  begin();
}

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                             const Eigen::VectorXd& frame_weights)
    : ClosedLoopRun(loop, frame_weights) {
  coded_ = std::move(coded);
  begin();
}

void ClosedLoopRun::begin() {
  errors_ = reconstruct(coded_, loop_.transform_.lifting) - loop_.original_.channels;
  pass([&](int j) { energy_ += errors_.col(j).dot(gradient_); });
}

ClosedLoop::Result ClosedLoopRun::run(const ClosedLoopWork& work,
                                      const Observer<ClosedLoopProgress>& observer) {
  ClosedLoop::Result result;
  if (work.compensate) pass([&](int j) { compensate(j); });
  result.eps_cm = eps_cm();
  const bool with_pairs = work.pairs && !weighted() && !loop_.model_.has_terms();
  while (result.sweeps < work.sweeps && result.complete) {
    // Pairs are for what single moves have left.
    if (with_pairs && 2 * result.sweeps >= work.sweeps) sweep_pairs();
    bit_price_ = price_of(result.sweeps, work.sweeps);
    pass([&](int j) { sweep(j); });
    ++result.sweeps;
    result.eps_cm = eps_cm();
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  }
  result.coded = std::move(coded_);
  return result;
}

double ClosedLoopRun::begin_sweeps(const ClosedLoopWork& work) {
  constexpr double kStillToCome = 0.12;  // a logarithm; alike for all clips, to 0.02
  pass([&](int j) { compensate(j); });
  bit_price_ = price_of(0, work.sweeps);
  pass([&](int j) { sweep(j); });
  return eps_cm() * std::exp(-kStillToCome);
}

ClosedLoop::Result ClosedLoopRun::settle(double eps_cm, const ClosedLoopWork& work,
                                         const Observer<ClosedLoopProgress>& observer) {
  constexpr int kMost = 4;
  ClosedLoop::Result result;
  const auto sweep_all = [&] {
    pass([&](int j) { sweep(j); });
    ++result.sweeps;
    result.eps_cm = this->eps_cm();
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  };
  result.sweeps = work.sweeps > 0 ? 1 : 0;
  result.eps_cm = this->eps_cm();
  bit_price_ = kLastBitPrice;
  while (result.sweeps < work.sweeps && result.complete) {
    bit_price_ = price_of(result.sweeps, work.sweeps);
    sweep_all();
  }
  for (int i = 0; i < kMost && result.complete; ++i) {
    const double off = std::log(result.eps_cm / eps_cm);
    if (off <= 0 && off >= -ClosedLoop::kSettled) break;
    bit_price_ *= dearer_for(-ClosedLoop::kSettled / 2 - off);
    sweep_all();
  }
  result.coded = std::move(coded_);
  return result;
}

ClosedLoop::Result ClosedLoopRun::coarsen(ErrorBound& bound,
                                          const Observer<ClosedLoopProgress>& observer) {
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
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  }
  result.coded = std::move(coded_);
  return result;
}

void ClosedLoopRun::move(int j, const Eigen::VectorXd& delta) {
  add_energy(j, 0, gradient_, delta);
  errors_.col(j) += delta;
  under_way_->add(delta);
}

void ClosedLoopRun::compensate(int j) {
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
  const double saved = rates_.bits(values_of(j)) - rates_.bits(values.data());
  if (energy_of(j, delta) >= lambda() * saved) return;
  coded_.values.col(j) = values;
  move(j, delta);
}

void ClosedLoopRun::sweep(int j) {
  // A zero that needs less than half a step stays one; moves of its neighbours change that
  // little.
  constexpr double kPromising = 0.4;
  Eigen::VectorXd gradient = gradient_;
  Eigen::VectorXd delta = Eigen::VectorXd::Zero(gradient.size());
  const int* const values = values_of(j);
  Significant significant = significant_in(j);
  if (bound_) bound_->next();
  Eigen::VectorXd slopes(gradient.size());
  loop_.transform_.lifting.correlate(
      std::span(gradient.data(), static_cast<std::size_t>(gradient.size())),
      std::span(slopes.data(), static_cast<std::size_t>(slopes.size())));
  const Eigen::VectorXd promising =
      kPromising * coded_.step(j) * coefficient_curvature().col(j).cwiseQuotient(loop_.gains_);
  // Where moves have changed the gradient, slopes are no longer what they were.
  Eigen::Index first_changed = gradient.size();
  Eigen::Index end_changed = 0;
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b)
    for (int i = 0; i < bands_[static_cast<std::size_t>(b)].size; ++i) {
      const int c = bands_[static_cast<std::size_t>(b)].first + i;
      if (values[c] == 0 && std::abs(slopes(c)) < promising(c)) continue;
      const SynthesisFunction reach = loop_.synthesis_[c];
      const bool changed =
          reach.first < end_changed && reach.first + reach.values.size() > first_changed;
      const Place place = changed ? place_of(j, b, i, gradient) : place_of(j, b, i, slopes(c));
      const int moved = best_move(place, significant);
      if (moved == 0) continue;
      const auto& [first, function] = place.function;
      const Eigen::VectorXd change = moved * place.step * function;
      if (bound_ && !bound_->allows(first, change)) continue;
      if (bound_) bound_->add(first, change);
      set(place, values[c] + moved, significant);
      first_changed = std::min<Eigen::Index>(first_changed, first);
      end_changed = std::max(end_changed, first + change.size());
      delta.segment(first, change.size()) += change;
      gradient.segment(first, change.size()) +=
          change.cwiseProduct(curvature().col(j).segment(first, change.size()));
    }
  if (!delta.isZero(0)) move(j, delta);
}

double ClosedLoopRun::eps_cm() const {
  return std::sqrt(std::max(energy_, 0.0) / std::max(loop_.original_.frames(), 1));
}

double ClosedLoopRun::total_bits() {
  double bits = 0;
  for (int j = 0; j < channels(); ++j) bits += rates_.bits(values_of(j));
  return bits;
}

Eigen::VectorXi ClosedLoopRun::quantised(int j, const Eigen::VectorXd& coefficients) const {
  const Eigen::ArrayXd steps = coefficients.cwiseProduct(loop_.gains_) / coded_.step(j);
  Eigen::VectorXi values(steps.size());
  for (Eigen::Index c = 0; c < steps.size(); ++c) {
    const double limited = std::clamp<double>(steps(c), -kMostSteps, kMostSteps);
    const auto cut = static_cast<int>(std::abs(limited) + (c < bands_[0].size ? 0.5 : kDeadZone));
    values(c) = limited < 0 ? -cut : cut;
  }
  return values;
}

double ClosedLoopRun::energy_of(int j, const Eigen::VectorXd& delta) const {
  return delta.dot(2 * gradient_ + curvature().col(j).cwiseProduct(delta));
}

void ClosedLoopRun::add_energy(int j, Eigen::Index first,
                               const Eigen::Ref<const Eigen::VectorXd>& gradient,
                               const Eigen::VectorXd& delta) {
  // By the model's own curvature: that of what moves nothing was raised, so as to have a step.
  Eigen::VectorXd curve = loop_.model_.curvature().col(j).segment(first, delta.size());
  if (weighted()) curve.array() *= frame_weights_.segment(first, delta.size()).array();
  energy_ += delta.dot(2 * gradient + curve.cwiseProduct(delta));
}

ClosedLoopRun::Place ClosedLoopRun::place_of(
    int j, int band, int index, const Eigen::Ref<const Eigen::VectorXd>& gradient) const {
  const auto& [first, values] =
      loop_.synthesis_[bands_[static_cast<std::size_t>(band)].first + index];
  return place_of(j, band, index, values.dot(gradient.segment(first, values.size())));
}

ClosedLoopRun::Place ClosedLoopRun::place_of(int j, int band, int index, double product) const {
  const int c = bands_[static_cast<std::size_t>(band)].first + index;
  const SynthesisFunction function = loop_.synthesis_[c];
  const double step = coded_.step(j) / loop_.gains_(c);
  return {.channel = j,
          .band = band,
          .index = index,
          .function = function,
          .step = step,
          .slope = step * product,
          .curve = step * step * coefficient_curvature()(c, j)};
}

void ClosedLoopRun::set(const Place& place, int value, Significant& significant) {
  int& mine = value_at(place);
  significant[static_cast<std::size_t>(place.band)] += (value != 0) - (mine != 0);
  mine = value;
}

ClosedLoopRun::Significant ClosedLoopRun::significant_in(int j) const {
  Significant significant;
  const int* const values = coded_.values.col(j).data();
  for (const Band& band : bands_)
    significant.push_back(static_cast<int>(
        band.size - std::count(values + band.first, values + band.first + band.size, 0)));
  return significant;
}

int ClosedLoopRun::best_move(const Place& place, const Significant& significant) {
  const int now = value_at(place);
  if (now == 0 && std::abs(place.slope) <= 0.5 * place.curve) return 0;
  const double best = now - place.slope / place.curve;
  if (!(std::abs(best) < kMostSteps)) return 0;
  const auto nearest = static_cast<int>(std::lround(best));
  const int smaller = nearest - (nearest > 0) + (nearest < 0);
  const auto error_at = [&](int value) {
    const double x = value - now;
    return x * (2 * place.slope + x * place.curve);
  };
  // Most coefficients are where they should be, and no saving would pay for another error.
  constexpr double kMostBits = 16;  // that a move can well save, but for a whole band
  if (nearest == now &&
      error_at(smaller) >= lambda() * (kMostBits + waking_bits(place, significant)))
    return 0;
  const Bits bits(*this, place, significant);
  const double bits_now = bits.with(now);
  int move = 0;
  double least = 0;
  for (const int value : {nearest, smaller}) {
    if (value == now) continue;
    const double cost = error_at(value) + lambda() * (bits.with(value) - bits_now);
    if (cost >= least) continue;
    least = cost;
    move = value - now;
  }
  return move;
}

ClosedLoopRun::Bits::Bits(const ClosedLoopRun& run, const Place& place,
                          const Significant& significant) {
  const int* const values = run.values_of(place.channel);
  const int i = place.index;
  if (place.band == 0) {
    before_ = i > 0 ? values[i - 1] : 0;
    if (i + 1 < run.bands_[0].size) after_ = values[i + 1];
    return;
  }
  waking_ = run.waking_bits(place, significant);
  around_.emplace(run.rates_, values, place.band, i);
}

double ClosedLoopRun::waking_bits(const Place& place, const Significant& significant) const {
  if (place.band == 0) return 0;
  const Band& band = bands_[static_cast<std::size_t>(place.band)];
  const bool was_something = values_of(place.channel)[band.first + place.index] != 0;
  const bool others = significant[static_cast<std::size_t>(place.band)] > (was_something ? 1 : 0);
  return others ? 0 : 4 + 0.05 * band.size;
}

double ClosedLoopRun::Bits::with(int value) const {
  if (around_) return (value == 0 ? 0 : waking_) + around_->bits(value);
  return RateTable::coarse_bits(value - before_) +
         (after_ ? RateTable::coarse_bits(*after_ - value) : 0);
}

void ClosedLoopRun::sweep_pairs() {
  constexpr int kReach = 12;  // channels: a joint, its parent and the parent's are near each other
  Eigen::MatrixXd gradient(errors_.rows(), errors_.cols());
  pass([&](int j) { gradient.col(j) = gradient_; });
  for (int a = 0; a < channels(); ++a)
    for (int b = a + 1; b < std::min(channels(), a + 1 + kReach); ++b)
      if (loop_.model_.are_related(a, b)) sweep_pair(a, b, gradient);
}

void ClosedLoopRun::sweep_pair(int a, int b, Eigen::MatrixXd& gradient) {
  const Eigen::VectorXd entry = loop_.model_.entry(a, b);
  Significant significant_in_a = significant_in(a);
  Significant significant_in_b = significant_in(b);
  for (int band = 1; band < static_cast<int>(bands_.size()); ++band)
    for (int i = 0; i < bands_[static_cast<std::size_t>(band)].size; ++i) {
      const int c = bands_[static_cast<std::size_t>(band)].first + i;
      if (coded_.values(c, a) == 0 && coded_.values(c, b) == 0) continue;
      const Place in_a = place_of(a, band, i, gradient.col(a));
      const Place in_b = place_of(b, band, i, gradient.col(b));
      const auto& [first, function] = in_a.function;
      const double cross =
          in_a.step * in_b.step * function.cwiseAbs2().dot(entry.segment(first, function.size()));
      if (!may_pay(in_a, in_b, cross)) continue;
      const auto [by_a, by_b] = best_moves(in_a, significant_in_a, in_b, significant_in_b, cross);
      move_of_pair(in_a, by_a, a, significant_in_a, gradient);
      move_of_pair(in_b, by_b, a, significant_in_b, gradient);
    }
}

double ClosedLoopRun::error_of(const Place& a, int by_a, const Place& b, int by_b, double cross) {
  return by_a * (2 * a.slope + by_a * a.curve) + by_b * (2 * b.slope + by_b * b.curve) +
         2 * by_a * by_b * cross;
}

bool ClosedLoopRun::may_pay(const Place& a, const Place& b, double cross) const {
  constexpr double kMostBits = 8;  // that a move by a step can well save
  for (const int by_a : {-1, 0, 1})
    for (const int by_b : {-1, 0, 1})
      if ((by_a != 0 || by_b != 0) && error_of(a, by_a, b, by_b, cross) < kMostBits * lambda())
        return true;
  return false;
}

std::pair<int, int> ClosedLoopRun::best_moves(const Place& a, const Significant& significant_in_a,
                                              const Place& b, const Significant& significant_in_b,
                                              double cross) {
  std::array<double, 3> bits_of_a;
  std::array<double, 3> bits_of_b;
  const Bits with_a(*this, a, significant_in_a);
  const Bits with_b(*this, b, significant_in_b);
  for (int by = -1; by <= 1; ++by) {
    bits_of_a[static_cast<std::size_t>(by + 1)] = with_a.with(value_at(a) + by);
    bits_of_b[static_cast<std::size_t>(by + 1)] = with_b.with(value_at(b) + by);
  }
  const double bits_now = bits_of_a[1] + bits_of_b[1];
  std::pair<int, int> best{0, 0};
  double least = 0;
  for (int by_a = -1; by_a <= 1; ++by_a)
    for (int by_b = -1; by_b <= 1; ++by_b) {
      const double bits = bits_of_a[static_cast<std::size_t>(by_a + 1)] +
                          bits_of_b[static_cast<std::size_t>(by_b + 1)];
      const double cost = error_of(a, by_a, b, by_b, cross) + lambda() * (bits - bits_now);
      if (cost >= least) continue;
      least = cost;
      best = {by_a, by_b};
    }
  return best;
}

void ClosedLoopRun::move_of_pair(const Place& place, int steps, int first_channel,
                                 Significant& significant, Eigen::MatrixXd& gradient) {
  if (steps == 0 || std::abs(value_at(place) + steps) > kMostSteps) return;
  const int j = place.channel;
  const auto& [first, function] = place.function;
  const Eigen::VectorXd delta = steps * place.step * function;
  add_energy(j, first, gradient.col(j).segment(first, delta.size()), delta);
  errors_.col(j).segment(first, delta.size()) += delta;
  loop_.model_.add_to_gradient(j, first, delta, first_channel, gradient);
  set(place, value_at(place) + steps, significant);
}

}  // namespace mocapress
