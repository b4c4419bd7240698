// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/closed_loop_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/base/parallel.h"
#include "core/codec/encode/closed_loop/constant_value.h"
#include "core/codec/encode/closed_loop/joint_search.h"
#include "core/codec/encode/closed_loop/price_control.h"
#include "core/codec/encode/closed_loop/step_kernels.h"

namespace mocapress {
namespace {

constexpr double kDeadZone = 0.25;  // added to a detail's size before it is cut to whole steps

/// A channel's step shrinks with its curvature to half this power. A power of 1 would give all
/// channels the same share of the error; 0.9 takes the fewest bytes on corpus/train (ADAPTIVE.md).
constexpr double kStepPower = 0.9;

/// Price of a bit in each sweep, in squared steps of error. Prices that rise and fall move
/// coefficients out of local minima: fewer bytes in fewer sweeps than falling prices (ADAPTIVE.md).
constexpr std::array kSettlingPrices = {0.054, 0.052, 0.02, 0.06, 0.03, 0.03};

/// From this sweep on, sweep_together() moves coefficients of several channels before sweep() moves
/// single ones.
constexpr int kFirstJoint = static_cast<int>(kSettlingPrices.size()) - 3;

constexpr double kLeastEps = 1e-12;  // cm; the eps_x of a clip that does not move

std::span<float> span_of(Eigen::ArrayXf& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights)
    : loop_(loop),
      bands_(loop.transform_.lifting.bands()),
      frame_weights_(loop.weights_with(frame_weights)),
      rates_(bands_),
      magnitudes_(static_cast<std::size_t>(channels()), Magnitudes(bands_)),
      significant_(static_cast<std::size_t>(channels()), Significant(bands_.size())),
      errors_(loop.original_.frames(), channels()),
      bit_price_(kSettlingPrices.front()),
      gradient_(Eigen::ArrayXf::Zero(errors_.rows() + ShortFunction::kVector)),
      delta_(gradient_),
      slopes_(errors_.rows()) {
  if (loop.frame_weights_.size() > 0) largest_weight_ = loop.frame_weights_.maxCoeff();
  if (!weighted()) return;
  weighted_curvature_ = loop.curvature_;
  weighted_curvature_.topRows(errors_.rows()).array().colwise() *= frame_weights_;
  weighted_coefficient_curvature_ = loop.coefficient_curvature(weighted_curvature_);
}

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, double scale,
                             const Eigen::VectorXd& frame_weights)
    : ClosedLoopRun(loop, frame_weights) {
  coded_.scale = file_scale(scale);
  for (int j = 0; j < channels(); ++j) coded_.step_exponent.push_back(step_exponent_of(j));
  coded_.values.resize(loop.transform_.per_channel(), channels());
  const Eigen::ArrayXf nothing = Eigen::ArrayXf::Zero(coded_.values.rows());
  for (int j = 0; j < channels(); ++j)
    coded_.values.col(j) = is_still(j) ? constant(j) : quantised(j, nothing);
  begin();
}

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, QuantisedSignals coded,
                             const Eigen::VectorXd& frame_weights)
    : ClosedLoopRun(loop, frame_weights) {
  coded_ = std::move(coded);
  begin();
}

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, ClosedLoop::Result settled)
    : ClosedLoopRun(loop, std::move(settled.coded), {}) {
  bit_price_ = settled.bit_price;
  growth_ = settled.growth;
  settling_ = static_cast<int>(std::ssize(kSettlingPrices));
}

void ClosedLoopRun::begin() {
  // These are small differences, not samples, so floats are precise enough.
  parallel_for(0, channels(), [&](int j) {
    Eigen::ArrayXf differences(errors_.rows());
    for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
      const Band& band = bands_[b];
      find_differences(values_of(j) + band.first, band.size, step_in(j, b),
                       loop_.transform_.values.col(j).data() + band.first,
                       differences.data() + band.first);
    }
    loop_.transform_.lifting.inverse(span_of(differences), span_of(differences));
    errors_.col(j) = differences;
    look_at(j);
  });
  find_energy();
}

ClosedLoop::Result ClosedLoopRun::run(ClosedLoopWork work,
                                      const Observer<ClosedLoopProgress>& observer) {
  ClosedLoop::Result result;
  if (work != ClosedLoopWork::Rounding) pass([&](int j) { compensate(j); });
  result.eps_cm = eps_cm();
  if (work == ClosedLoopWork::Sweeps) {
    settle_by_prices(result, observer);
    result.bit_price = bit_price_;
    result.growth = growth_;
  }
  result.coded = std::move(coded_);
  result.errors = std::move(errors_);
  return result;
}

void ClosedLoopRun::sweep_all(ClosedLoop::Result& result,
                              const Observer<ClosedLoopProgress>& observer) {
  if (settling_ >= kFirstJoint) sweep_together();
  pass([&](int j) { sweep(j); });
  ++result.sweeps;
  const double before = std::exchange(result.eps_cm, eps_cm());
  growth_ = std::log(std::max(result.eps_cm, kLeastEps) / std::max(before, kLeastEps));
  result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
}

void ClosedLoopRun::settle_by_prices(ClosedLoop::Result& result,
                                     const Observer<ClosedLoopProgress>& observer) {
  for (; settling_ < std::ssize(kSettlingPrices) && result.complete; ++settling_) {
    bit_price_ = kSettlingPrices[settling_];
    sweep_all(result, observer);
  }
}

double ClosedLoopRun::begin_settling() {
  constexpr double kStillToCome = 0.12;  // a logarithm, larger than the sweeps' true gain because
                                         // that saves bytes (ADAPTIVE.md)
  spare_ends();
  pass([&](int j) { compensate(j); });
  bit_price_ = kSettlingPrices.front();
  pass([&](int j) { sweep(j); });
  settling_ = 1;
  return eps_cm() * std::exp(-kStillToCome);
}

ClosedLoop::Result ClosedLoopRun::settle(double eps_cm,
                                         const Observer<ClosedLoopProgress>& observer) {
  constexpr int kMost = 4;
  spare_ends();
  ClosedLoop::Result result;
  result.sweeps = settling_ < std::ssize(kSettlingPrices) ? settling_ : 0;
  result.eps_cm = this->eps_cm();
  settle_by_prices(result, observer);
  PriceControl control(growth_);
  for (int i = 0; i < kMost && result.complete; ++i) {
    const double off = std::log(std::max(result.eps_cm, kLeastEps) / eps_cm);
    if (off <= 0 && off >= -ClosedLoop::kSettled) break;
    bit_price_ *= control.factor_for(-ClosedLoop::kSettled / 2 - off);
    sweep_all(result, observer);
    control.observe(growth_);
  }
  result.bit_price = bit_price_;
  result.growth = growth_;
  result.coded = std::move(coded_);
  return result;
}

ClosedLoop::Result ClosedLoopRun::coarsen(ErrorBound& bound,
                                          const Observer<ClosedLoopProgress>& observer) {
  constexpr double kDearer = 1.5;  // factor of the bit price from sweep to sweep
  constexpr double kAgain = 0.25;  // factor of the last price when coarsening resumes
  constexpr int kMostSweeps = 24;
  constexpr int kLeastSweeps = 4;
  constexpr double kNear = 0.985;
  constexpr double kLeastGain = 0.01;
  ClosedLoop::Result result;
  bound_ = &bound;
  const double bits_at_first = total_bits();
  double bits = bits_at_first;
  bit_price_ = std::max(kSettlingPrices.front(), kAgain * bit_price_);
  for (bool gains = true; gains && result.sweeps < kMostSweeps && result.complete;) {
    bit_price_ *= kDearer;
    bound.begin(decoded());
    pass([&](int j) { sweep(j); });
    ++result.sweeps;
    result.eps_cm = eps_cm();
    const double before = std::exchange(bits, total_bits());
    gains = result.sweeps < kLeastSweeps || bound.furthest() < kNear ||
            bits < (1 - kLeastGain) * before || bits > bits_at_first;
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  }
  result.bit_price = bit_price_;
  result.coded = std::move(coded_);
  return result;
}

void ClosedLoopRun::move(int j, const Samples& gradient, const Samples& delta) {
  energy_ += energy_of(j, 0, gradient, delta);
  errors_.col(j).array() += delta;
  under_way_->add(delta);
}

void ClosedLoopRun::compensate(int j) {
  constexpr float kDamping = 0.1F;
  if (is_still(j)) return;
  const Eigen::Index frames = errors_.rows();
  const auto curve = curvature().col(j).head(frames).array();
  const auto gradient = gradient_.head(frames);
  const float damping = kDamping * curve.mean();
  Eigen::ArrayXf less = (gradient - curve * errors_.col(j).array()) / (curve + damping);
  loop_.transform_.lifting.forward(span_of(less), span_of(less));
  const Eigen::VectorXi values = quantised(j, less);
  if (values == coded_.values.col(j)) return;
  const Eigen::ArrayXf delta = samples_of(j, (values - coded_.values.col(j)).cast<float>().array());
  Magnitudes magnitudes(bands_);
  magnitudes.read(bands_, values.data());
  const double saved =
      rates_.bits(values_of(j), magnitudes_of(j)) - rates_.bits(values.data(), magnitudes);
  if (energy_of(j, 0, gradient, delta) >= lambda() * saved) return;
  coded_.values.col(j) = values;
  look_at(j);
  move(j, gradient, delta);
}

void ClosedLoopRun::find_slopes() {
  loop_.transform_.lifting.correlate(
      std::span(std::as_const(gradient_).data(), static_cast<std::size_t>(errors_.rows())),
      span_of(slopes_));
}

void ClosedLoopRun::sweep(int j) {
  // A zero stays zero if its best value is below this many steps. Moves of its neighbours change
  // that value little.
  constexpr double kPromising = 0.4;
  const Eigen::Index frames = errors_.rows();
  const int* const values = values_of(j);
  const float* const curve = curvature().col(j).data();
  const float* const coefficient_curve = coefficient_curvature().col(j).data();
  if (bound_) bound_->next();
  if (is_still(j)) return;
  find_slopes();
  // Moves have changed the gradient in these frames, so the slopes must be computed again.
  int first_changed = static_cast<int>(frames);
  int end_changed = 0;
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[b];
    const double step = step_in(j, b);
    const auto promising = static_cast<float>(kPromising * step);
    visit_where(band, values, slopes_.data(), coefficient_curve, promising, [&](int c) {
      const ShortFunction function = loop_.functions_[c];
      const bool changed = function.first() < end_changed && function.end() > first_changed;
      const Place place = place_of(j, b, c - band.first, step,
                                   changed ? function.dot(gradient_.data()) : slopes_(c));
      const int moved = best_move(place);
      if (moved == 0) return;
      const auto by = static_cast<float>(moved * step);
      if (bound_) {
        const Eigen::VectorXd change = (by * function.values()).matrix().cast<double>();
        if (!bound_->allows(function.first(), change)) return;
        bound_->add(function.first(), change);
      }
      set(place, values[c] + moved);
      if (end_changed == 0) delta_.setZero();
      first_changed = std::min(first_changed, function.first());
      end_changed = std::max(end_changed, function.end());
      function.visit([&](int at, const auto& part) {
        using Part = Eigen::Array<float, ShortFunction::kVector, 1>;
        const Part change = by * part;
        Eigen::Map<Part>(delta_.data() + at) += change;
        Eigen::Map<Part>(gradient_.data() + at) += change * Eigen::Map<const Part>(curve + at);
      });
    });
  }
  if (end_changed == 0) return;
  if (weighted())
    move(j, under_way_->gradient() * frame_weights_, delta_.head(frames));
  else
    move(j, under_way_->gradient(), delta_.head(frames));
}

double ClosedLoopRun::eps_cm() const {
  return std::sqrt(std::max(energy_, 0.0) / std::max(loop_.original_.frames(), 1));
}

double ClosedLoopRun::total_bits() {
  double bits = 0;
  for (int j = 0; j < channels(); ++j) bits += rates_.bits(values_of(j), magnitudes_of(j));
  return bits;
}

int ClosedLoopRun::step_exponent_of(int j) const {
  if (is_still(j) && !loop_.original_.channels.col(j).isZero()) return step_exponent_of_still(j);
  const double exponent = kStepPower * std::log2(loop_.mean_curvature_(j));
  return std::clamp(static_cast<int>(std::lround(exponent)), kLeastStepExponent, kMostStepExponent);
}

int ClosedLoopRun::step_exponent_of_still(int j) const {
  // Half octaves from the scale down to the step of the coarse samples. The number is even, so that
  // the step is the scale times a power of two and has no more binary digits.
  constexpr int kFinest = 16;
  const double value = std::abs(loop_.original_.channels(0, j));
  int finer = kFinest;
  while (value > kMostSteps / 2 * step_of(finer, coded_.scale)) finer -= 2;
  const int depth = static_cast<int>(bands_.size()) - 1;  // of the coarse samples
  return std::clamp(finer - depth, kLeastStepExponent, kMostStepExponent);
}

Eigen::VectorXi ClosedLoopRun::constant(int j) const {
  Eigen::VectorXi values = Eigen::VectorXi::Zero(coded_.values.rows());
  if (values.size() > 0)
    values.head(bands_.front().size)
        .setConstant(steps_of_constant(loop_.original_.channels(0, j), step_in(j, 0)));
  return values;
}

Eigen::VectorXi ClosedLoopRun::quantised(int j, const Samples& less) const {
  Eigen::VectorXi values(less.size());
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[b];
    const double per_unit = 1 / step_in(j, b);
    cut_to_steps(loop_.transform_.values.col(j).data() + band.first, less.data() + band.first,
                 band.size, per_unit, b == 0 ? 0.5 : kDeadZone, values.data() + band.first);
  }
  return values;
}

Eigen::ArrayXf ClosedLoopRun::samples_of(int j, Eigen::ArrayXf steps) const {
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[b];
    steps.segment(band.first, band.size) *= static_cast<float>(step_in(j, b));
  }
  loop_.transform_.lifting.inverse(span_of(steps), span_of(steps));
  return steps;
}

double ClosedLoopRun::energy_of(int j, Eigen::Index first, const Samples& gradient,
                                const Samples& delta) const {
  // Uses the model's own curvature, because curvature_ was raised where the channel moves nothing.
  const auto curve = loop_.model_curvature_.col(j).segment(first, delta.size()).array();
  return static_cast<double>(
      weighted()
          ? (delta * (2 * gradient + curve * frame_weights_.segment(first, delta.size()) * delta))
                .sum()
          : (delta * (2 * gradient + curve * delta)).sum());
}

ClosedLoopRun::Place ClosedLoopRun::place_of(int j, int band, int index, double step,
                                             double product) const {
  const int c = bands_[band].first + index;
  return {.channel = j,
          .band = band,
          .index = index,
          .function = loop_.functions_[c],
          .step = step,
          .slope = step * product,
          .curve = step * step * static_cast<double>(coefficient_curvature()(c, j))};
}

void ClosedLoopRun::set(const Place& place, int value) {
  const auto j = static_cast<std::size_t>(place.channel);
  const auto band = static_cast<std::size_t>(place.band);
  int& mine = values_of(place.channel)[coefficient_at(place)];
  significant_[j][band] += (value != 0) - (mine != 0);
  magnitudes_[j].set(place.band, place.index, value);
  mine = value;
}

void ClosedLoopRun::look_at(int j) {
  const int* const values = values_of(j);
  magnitudes_[j].read(bands_, values);
  for (std::size_t b = 0; b < bands_.size(); ++b)
    significant_[j][b] =
        static_cast<int>(bands_[b].size - std::count(values + bands_[b].first,
                                                     values + bands_[b].first + bands_[b].size, 0));
}

int ClosedLoopRun::best_move(const Place& place) const {
  const int now = value_at(place);
  if (now == 0 && std::abs(place.slope) <= 0.5 * place.curve) return 0;
  const double best = -place.slope / place.curve;  // from the current value
  if (!(std::abs(now + best) < kMostSteps)) return 0;
  const int nearest = now + static_cast<int>(best < 0 ? best - 0.5 : best + 0.5);
  const int smaller = nearest - (nearest > 0) + (nearest < 0);
  const auto error_at = [&](int value) {
    const double x = value - now;
    return x * (2 * place.slope + x * place.curve);
  };
  const double price = lambda_of(coefficient_at(place));
  // Returns early for most coefficients: they are at their best value already, and no saving of
  // bits would pay for a larger error.
  if (nearest == now && place.band > 0) {
    const double waking = waking_bits(place);
    const auto pays = [&](double saved) { return error_at(smaller) < price * (saved + waking); };
    if (!pays(RateTable::kMostSaved)) return 0;
    const Magnitudes& magnitudes = magnitudes_of(place.channel);
    const auto bits_of = [&](int value) {
      return rates_.bits(magnitudes, place.band, place.index, value);
    };
    if (!pays(bits_of(now) - bits_of(smaller) + RateTable::kMostSavedBeside)) return 0;
  }
  const Bits bits(*this, place);
  const double bits_now = bits.with(now);
  int move = 0;
  double least = 0;
  for (const int value : {nearest, smaller}) {
    if (value == now) continue;
    const double cost = error_at(value) + price * (bits.with(value) - bits_now);
    if (cost >= least) continue;
    least = cost;
    move = value - now;
  }
  return move;
}

ClosedLoopRun::Bits::Bits(const ClosedLoopRun& run, const Place& place) {
  const int i = place.index;
  if (place.band == 0) {
    const int* const values = run.values_of(place.channel);
    before_ = i > 0 ? values[i - 1] : 0;
    if (i + 1 < run.bands_[0].size) after_ = values[i + 1];
    return;
  }
  waking_ = run.waking_bits(place);
  around_.emplace(run.rates_, run.magnitudes_of(place.channel), place.band, i);
}

double ClosedLoopRun::lambda_of(int coefficient) const {
  return end_prices_ ? end_prices_->price(reaches_[coefficient], lambda()) : lambda();
}

void ClosedLoopRun::spare_ends() {
  if (end_prices_ || errors_.rows() < EndPrices::kFewestFrames) return;
  end_prices_.emplace(errors_.rows());
  for (int c = 0; c < loop_.transform_.per_channel(); ++c)
    reaches_.push_back(end_prices_->reach_of(loop_.functions_[c]));
}

double ClosedLoopRun::waking_bits(const Place& place) const {
  if (place.band == 0) return 0;
  const auto band = static_cast<std::size_t>(place.band);
  const int others = significant_[place.channel][band] - (value_at(place) != 0 ? 1 : 0);
  return others > 0 ? 0 : 4 + 0.05 * bands_[band].size;
}

double ClosedLoopRun::Bits::with(int value) const {
  if (around_) return (value == 0 ? 0 : waking_) + around_->bits(value);
  return RateTable::coarse_bits(value - before_) +
         (after_ ? RateTable::coarse_bits(*after_ - value) : 0);
}

void ClosedLoopRun::sweep_together() {
  // Moves in one band hardly change the slopes of bands this far apart. Within a band they do, but
  // updating the slopes after each move saves no bytes (ADAPTIVE.md).
  constexpr int kApart = 3;
  const auto count = static_cast<int>(bands_.size());
  together_.taking_part.resize(errors_.rows());
  for (int first = 0; first < std::min(kApart, count); ++first) {
    for (std::vector<int>& channels : together_.taking_part) channels.clear();
    loop_.model_.find_gradient(errors_, together_.slopes);
    for (int j = 0; j < channels(); ++j) {
      auto slopes = together_.slopes.col(j).head(errors_.rows());
      if (weighted()) slopes.array() *= frame_weights_;
      const std::span of_channel(slopes.data(), static_cast<std::size_t>(slopes.size()));
      loop_.transform_.lifting.correlate(of_channel, of_channel);
      for (int b = first; b < count; b += kApart) find_taking_part(j, b);
    }
    std::vector<Eigen::ArrayXf> moves(channels());
    for (int b = first; b < count; b += kApart)
      for (int i = 0; i < bands_[b].size; ++i) move_together(b, i, moves);
    for (int j = 0; j < channels(); ++j)
      if (Eigen::ArrayXf& steps = moves[j]; steps.size() > 0)
        errors_.col(j).array() += samples_of(j, std::move(steps));
  }
  find_energy();
}

bool ClosedLoopRun::weigh_alike(const ShortFunction& function) const {
  constexpr float kMost = 10;
  if (!weighted()) return true;
  const auto weights = frame_weights_.segment(function.first(), function.size());
  return weights.maxCoeff() <= kMost * weights.minCoeff();
}

void ClosedLoopRun::find_energy() {
  energy_ = 0;
  if (errors_.rows() == 0) return;
  if (under_way_)
    under_way_->restart();
  else
    under_way_.emplace(loop_.model_, errors_);
  Eigen::ArrayXd energies = under_way_->energies().cast<double>();
  if (weighted()) energies *= frame_weights_.cast<double>();
  energy_ = energies.sum();
  if (!end_prices_) return;
  constexpr Eigen::Index kSeen = EndPrices::kSeen;
  end_prices_->observe({energies.head(kSeen).sum(), energies.tail(kSeen).sum()},
                       kSeen * energies.mean());
}

void ClosedLoopRun::find_taking_part(int j, int b) {
  constexpr double kPromising = 0.4;  // a zero takes part if its best value is this many steps off
  // Time and memory grow with the square of the number of channels that are weighed against each
  // other. If there are more, the ones nearest to the root take part; sweep() moves the others one
  // by one.
  constexpr std::size_t kMostTogether = 512;
  if (is_still(j)) return;
  visit_where(
      bands_[b], values_of(j), together_.slopes.col(j).data(),
      coefficient_curvature().col(j).data(), static_cast<float>(kPromising * step_in(j, b)),
      [&](int c) {
        auto& taking_part = together_.taking_part[c];
        if (std::abs(coded_.values(c, j)) <= kMostSteps - 1 && taking_part.size() < kMostTogether)
          taking_part.push_back(j);
      });
}

void ClosedLoopRun::move_together(int band, int index, std::vector<Eigen::ArrayXf>& moves) {
  const int coefficient = bands_[band].first + index;
  const std::vector<int>& taking_part = together_.taking_part[coefficient];
  const auto count = std::ssize(taking_part);
  if (count < 2) return;
  const ShortFunction function = loop_.functions_[coefficient];
  if (!weigh_alike(function)) return;
  const auto in_bits = static_cast<float>(1 / lambda_of(coefficient));
  std::vector<Place> places;
  std::vector<JointSearch::Coefficient> coefficients;
  places.reserve(taking_part.size());
  coefficients.reserve(taking_part.size());
  for (const int j : taking_part) {
    const Place& place = places.emplace_back(place_of(
        j, band, index, step_in(j, band), static_cast<double>(together_.slopes(coefficient, j))));
    const Bits bits(*this, place);
    const int value = value_at(place);
    const auto price_of = [&](int by) { return static_cast<float>(bits.with(value + by)); };
    coefficients.push_back({static_cast<float>(place.slope) * in_bits,
                            static_cast<float>(place.curve) * in_bits,
                            {price_of(-1), price_of(0), price_of(1)}});
  }
  Eigen::MatrixXf cross = Eigen::MatrixXf::Zero(JointSearch::rows_for(count), count);
  loop_.model_.sum_squares(taking_part, function, cross);
  // Scales the sampled sums to the curvature, which covers every frame.
  Eigen::ArrayXf factors = Eigen::ArrayXf::Zero(cross.rows());
  for (Eigen::Index i = 0; i < count; ++i)
    if (cross(i, i) > 0) factors(i) = std::sqrt(coefficients[i].curve / cross(i, i));
  for (Eigen::Index i = 0; i < count; ++i) {
    cross.col(i).array() *= factors(i) * factors;
    cross(i, i) = coefficients[i].curve;
  }
  JointSearch search(coefficients, cross);
  const std::vector<int>& found = search.run();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (found[i] == 0) continue;
    set(places[i], value_at(places[i]) + found[i]);
    Eigen::ArrayXf& steps = moves[places[i].channel];
    if (steps.size() == 0) steps = Eigen::ArrayXf::Zero(errors_.rows());
    steps(coefficient) = static_cast<float>(found[i]);
  }
}

}  // namespace mocapress
