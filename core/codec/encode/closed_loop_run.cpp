// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop_run.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "core/base/instruction_sets.h"
#include "core/base/parallel.h"
#include "core/codec/encode/price_control.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mocapress {

namespace {

constexpr double kDeadZone = 0.25;  // what is added before details are cut to whole steps

/// Steps shrink with what a channel moves, squared, to half this power. One would give all channels
/// the same share of the error; on corpus/train this takes the fewest bytes (ADAPTIVE.md).
constexpr double kStepPower = 0.9;

// Squared steps of error that a bit is worth, in the first sweep and in the last.
constexpr double kFirstBitPrice = 0.054;
constexpr double kLastBitPrice = 0.041;

/// Of the sweeps of what settles at an error. Bits that are now cheap, now dear, shake coefficients
/// out of where they would stay: fewer bytes than prices that fall, in fewer sweeps (ADAPTIVE.md).
constexpr std::array kSettlingPrices = {0.054, 0.052, 0.02, 0.06,  0.03,
                                        0.06,  0.025, 0.05, 0.025, 0.02};

/// Where steps are fine a clip has many coefficients, and two sweeps less leave as many bytes.
constexpr std::array kFineSettlingPrices = {0.054, 0.02, 0.06, 0.03, 0.06, 0.02, 0.05, 0.025};
constexpr double kLeastCoarseScale = 0.35;  // cm

std::span<const double> settling_prices(double scale) {
  if (scale < kLeastCoarseScale) return kFineSettlingPrices;
  return kSettlingPrices;
}

/// One sweep with pairs of channels among those of coarse steps, where it pays most.
constexpr int kPairsInSettling = 6;

// Channels: a joint, its parent and the parent's are near each other.
constexpr int kNearReach = 6;
constexpr int kFarReach = 12;

double price_of(int sweep, int sweeps) {
  return kFirstBitPrice + (kLastBitPrice - kFirstBitPrice) * sweep / std::max(sweeps - 1, 1);
}

// Loops below are over so many numbers as are known beforehand: of such the compiler makes vector
// instructions.
constexpr int kAtATime = 8;

/// Whole steps in what is left of some coefficients when `less` is taken off.
template <int kCount>
MOCAPRESS_INLINE void cut_to_steps(const double* __restrict coefficients,
                                   const float* __restrict less, double per_unit, double added,
                                   int* __restrict values) {
  for (int i = 0; i < kCount; ++i) {
    const double steps = (coefficients[i] - static_cast<double>(less[i])) * per_unit;
    const double size = std::abs(steps) < kMostSteps ? std::abs(steps) : kMostSteps;
    values[i] = static_cast<int>(std::copysign(size + added, steps));
  }
}

/// What so many steps lack of the coefficients.
template <int kCount>
MOCAPRESS_INLINE void find_differences(const int* __restrict values, double step,
                                       const double* __restrict coefficients,
                                       float* __restrict differences) {
  for (int i = 0; i < kCount; ++i)
    differences[i] = static_cast<float>(values[i] * step - coefficients[i]);
}

#ifdef MOCAPRESS_WITH_AVX2
MOCAPRESS_FOR_AVX2 void cut_to_steps_with_avx2(const double* coefficients, const float* less,
                                               double per_unit, double added, int* values) {
  cut_to_steps<kAtATime>(coefficients, less, per_unit, added, values);
}
MOCAPRESS_FOR_AVX2 void find_differences_with_avx2(const int* values, double step,
                                                   const double* coefficients, float* differences) {
  find_differences<kAtATime>(values, step, coefficients, differences);
}
#endif

void cut_to_steps(const double* coefficients, const float* less, int count, double per_unit,
                  double added, int* values) {
  int i = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2())
    for (; i + kAtATime <= count; i += kAtATime)
      cut_to_steps_with_avx2(coefficients + i, less + i, per_unit, added, values + i);
#endif
  for (; i + 4 <= count; i += 4)
    cut_to_steps<4>(coefficients + i, less + i, per_unit, added, values + i);
  for (; i < count; ++i) cut_to_steps<1>(coefficients + i, less + i, per_unit, added, values + i);
}

void find_differences(const int* values, int count, double step, const double* coefficients,
                      float* differences) {
  int i = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2())
    for (; i + kAtATime <= count; i += kAtATime)
      find_differences_with_avx2(values + i, step, coefficients + i, differences + i);
#endif
  for (; i + 4 <= count; i += 4)
    find_differences<4>(values + i, step, coefficients + i, differences + i);
  for (; i < count; ++i) find_differences<1>(values + i, step, coefficients + i, differences + i);
}

std::span<float> span_of(Eigen::ArrayXf& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

/// Calls visit(coefficient) for those of a band that are not zero or whose slope is steep: at least
/// `threshold` times their curvature.
template <typename Visit>
void visit_where(const Band& band, const int* values, const float* slopes, const float* curves,
                 float threshold, const Visit& visit) {
  int c = band.first;
  const int end = band.first + band.size;
#ifdef __SSE2__
  const __m128 no_sign = _mm_castsi128_ps(_mm_set1_epi32(0x7FFFFFFF));
  const __m128 least = _mm_set1_ps(threshold);
  const auto found_in_four = [&](int at) {
    const __m128 steep = _mm_cmpge_ps(_mm_and_ps(_mm_loadu_ps(slopes + at), no_sign),
                                      _mm_mul_ps(least, _mm_loadu_ps(curves + at)));
    const __m128i zero = _mm_cmpeq_epi32(
        _mm_loadu_si128(reinterpret_cast<const __m128i*>(values + at)), _mm_setzero_si128());
    return _mm_or_ps(steep,
                     _mm_xor_ps(_mm_castsi128_ps(zero), _mm_castsi128_ps(_mm_set1_epi32(-1))));
  };
  for (; c + 4 <= end; c += 4)
    for (int found = _mm_movemask_ps(found_in_four(c)); found != 0; found &= found - 1)
      visit(c + std::countr_zero(static_cast<unsigned>(found)));
#endif
  for (; c < end; ++c)
    if (values[c] != 0 || std::abs(slopes[c]) >= threshold * curves[c]) visit(c);
}

}  // namespace

ClosedLoopRun::ClosedLoopRun(const ClosedLoop& loop, const Eigen::VectorXd& frame_weights)
    : loop_(loop),
      bands_(loop.transform_.lifting.bands()),
      frame_weights_(frame_weights.cast<float>()),
      rates_(bands_),
      magnitudes_(static_cast<std::size_t>(channels()), Magnitudes(bands_)),
      significant_(static_cast<std::size_t>(channels()), Significant(bands_.size())),
      errors_(loop.original_.frames(), channels()),
      bit_price_(kFirstBitPrice),
      gradient_(Eigen::ArrayXf::Zero(errors_.rows() + ShortFunction::kVector)),
      delta_(gradient_),
      slopes_(errors_.rows()) {
  if (!weighted()) return;
  weighted_curvature_ = loop.curvature_;
  weighted_curvature_.topRows(errors_.rows()).array().colwise() *= frame_weights_;
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
  const Eigen::ArrayXf nothing = Eigen::ArrayXf::Zero(coded_.values.rows());
  for (int j = 0; j < channels(); ++j) coded_.values.col(j) = quantised(j, nothing);
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
  settling_ = static_cast<int>(std::ssize(settling_prices(coded_.scale)));
}

void ClosedLoopRun::begin() {
  // Of the small differences between coefficients, not of the samples themselves: floats will do.
  parallel_for(0, channels(), [&](int j) {
    Eigen::ArrayXf differences(errors_.rows());
    for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
      const Band& band = bands_[static_cast<std::size_t>(b)];
      find_differences(values_of(j) + band.first, band.size, step_in(j, b),
                       loop_.transform_.values.col(j).data() + band.first,
                       differences.data() + band.first);
    }
    loop_.transform_.lifting.inverse(span_of(differences), span_of(differences));
    errors_.col(j) = differences;
    look_at(j);
  });
  const Eigen::Index frames = errors_.rows();
  pass([&](int j) { energy_ += errors_.col(j).dot(gradient_.head(frames).matrix()); });
}

ClosedLoop::Result ClosedLoopRun::run(const ClosedLoopWork& work,
                                      const Observer<ClosedLoopProgress>& observer) {
  ClosedLoop::Result result;
  if (work.compensate) pass([&](int j) { compensate(j); });
  result.eps_cm = eps_cm();
  const bool with_pairs = work.pairs && may_pair();
  while (result.sweeps < work.sweeps && result.complete) {
    // Pairs are for what single moves have left.
    if (with_pairs && 2 * result.sweeps >= work.sweeps) sweep_pairs(kFarReach);
    bit_price_ = price_of(result.sweeps, work.sweeps);
    pass([&](int j) { sweep(j); });
    ++result.sweeps;
    result.eps_cm = eps_cm();
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  }
  result.coded = std::move(coded_);
  result.errors = std::move(errors_);
  return result;
}

double ClosedLoopRun::begin_settling() {
  constexpr double kStillToCome = 0.12;  // a logarithm; alike for all clips, to 0.02
  pass([&](int j) { compensate(j); });
  bit_price_ = settling_prices(coded_.scale).front();
  pass([&](int j) { sweep(j); });
  settling_ = 1;
  return eps_cm() * std::exp(-kStillToCome);
}

ClosedLoop::Result ClosedLoopRun::settle(double eps_cm, bool pairs,
                                         const Observer<ClosedLoopProgress>& observer) {
  constexpr int kMost = 4;
  constexpr double kLeastEps = 1e-12;
  ClosedLoop::Result result;
  const std::span<const double> prices = settling_prices(coded_.scale);
  const bool with_pairs = pairs && coded_.scale >= kLeastCoarseScale && may_pair();
  const auto sweep_all = [&] {
    pass([&](int j) { sweep(j); });
    ++result.sweeps;
    const double before = std::exchange(result.eps_cm, this->eps_cm());
    growth_ = std::log(std::max(result.eps_cm, kLeastEps) / std::max(before, kLeastEps));
    result.complete = should_continue(observer, ClosedLoopProgress{result.sweeps, result.eps_cm});
  };
  result.sweeps = settling_ < std::ssize(prices) ? settling_ : 0;
  result.eps_cm = this->eps_cm();
  for (; settling_ < std::ssize(prices) && result.complete; ++settling_) {
    bit_price_ = prices[static_cast<std::size_t>(settling_)];
    if (with_pairs && settling_ == kPairsInSettling) sweep_pairs(kNearReach);
    sweep_all();
  }
  PriceControl control(growth_);
  for (int i = 0; i < kMost && result.complete; ++i) {
    const double off = std::log(std::max(result.eps_cm, kLeastEps) / eps_cm);
    if (off <= 0 && off >= -ClosedLoop::kSettled) break;
    bit_price_ *= control.factor_for(-ClosedLoop::kSettled / 2 - off);
    sweep_all();
    control.observe(growth_);
  }
  result.bit_price = bit_price_;
  result.growth = growth_;
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

void ClosedLoopRun::move(int j, const Samples& gradient, const Samples& delta) {
  energy_ += energy_of(j, 0, gradient, delta);
  errors_.col(j).array() += delta;
  under_way_->add(delta);
}

void ClosedLoopRun::compensate(int j) {
  constexpr float kDamping = 0.1F;
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

void ClosedLoopRun::sweep(int j) {
  // A zero that needs less than half a step stays one; moves of its neighbours change that
  // little.
  constexpr double kPromising = 0.4;
  const Eigen::Index frames = errors_.rows();
  const int* const values = values_of(j);
  const float* const curve = curvature().col(j).data();
  const float* const coefficient_curve = coefficient_curvature().col(j).data();
  if (bound_) bound_->next();
  loop_.transform_.lifting.correlate(
      std::span(std::as_const(gradient_).data(), static_cast<std::size_t>(frames)),
      span_of(slopes_));
  // Where moves have changed the gradient, slopes are no longer what they were.
  int first_changed = static_cast<int>(frames);
  int end_changed = 0;
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[static_cast<std::size_t>(b)];
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

Eigen::VectorXi ClosedLoopRun::quantised(int j, const Samples& less) const {
  Eigen::VectorXi values(less.size());
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    const double per_unit = 1 / step_in(j, b);
    cut_to_steps(loop_.transform_.values.col(j).data() + band.first, less.data() + band.first,
                 band.size, per_unit, b == 0 ? 0.5 : kDeadZone, values.data() + band.first);
  }
  return values;
}

Eigen::ArrayXf ClosedLoopRun::samples_of(int j, Eigen::ArrayXf steps) const {
  for (int b = 0; b < static_cast<int>(bands_.size()); ++b) {
    const Band& band = bands_[static_cast<std::size_t>(b)];
    steps.segment(band.first, band.size) *= static_cast<float>(step_in(j, b));
  }
  loop_.transform_.lifting.inverse(span_of(steps), span_of(steps));
  return steps;
}

double ClosedLoopRun::energy_of(int j, Eigen::Index first, const Samples& gradient,
                                const Samples& delta) const {
  // By the model's own curvature: that of what moves nothing was raised, so as to have a step.
  const auto curve = loop_.model_curvature_.col(j).segment(first, delta.size()).array();
  return static_cast<double>(
      weighted()
          ? (delta * (2 * gradient + curve * frame_weights_.segment(first, delta.size()) * delta))
                .sum()
          : (delta * (2 * gradient + curve * delta)).sum());
}

ClosedLoopRun::Place ClosedLoopRun::place_of(int j, int band, int index, double step,
                                             double product) const {
  const int c = bands_[static_cast<std::size_t>(band)].first + index;
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
  int& mine = values_of(place.channel)[bands_[band].first + place.index];
  significant_[j][band] += (value != 0) - (mine != 0);
  magnitudes_[j].set(place.band, place.index, value);
  mine = value;
}

void ClosedLoopRun::look_at(int j) {
  const int* const values = values_of(j);
  magnitudes_[static_cast<std::size_t>(j)].read(bands_, values);
  for (std::size_t b = 0; b < bands_.size(); ++b)
    significant_[static_cast<std::size_t>(j)][b] =
        static_cast<int>(bands_[b].size - std::count(values + bands_[b].first,
                                                     values + bands_[b].first + bands_[b].size, 0));
}

int ClosedLoopRun::best_move(const Place& place) const {
  const int now = value_at(place);
  if (now == 0 && std::abs(place.slope) <= 0.5 * place.curve) return 0;
  const double best = -place.slope / place.curve;  // from where it is
  if (!(std::abs(now + best) < kMostSteps)) return 0;
  const int nearest = now + static_cast<int>(best < 0 ? best - 0.5 : best + 0.5);
  const int smaller = nearest - (nearest > 0) + (nearest < 0);
  const auto error_at = [&](int value) {
    const double x = value - now;
    return x * (2 * place.slope + x * place.curve);
  };
  // Most coefficients are where they should be, and no saving would pay for another error.
  if (nearest == now && place.band > 0) {
    const double waking = waking_bits(place);
    const auto pays = [&](double saved) { return error_at(smaller) < lambda() * (saved + waking); };
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
    const double cost = error_at(value) + lambda() * (bits.with(value) - bits_now);
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

double ClosedLoopRun::waking_bits(const Place& place) const {
  if (place.band == 0) return 0;
  const auto band = static_cast<std::size_t>(place.band);
  const int others =
      significant_[static_cast<std::size_t>(place.channel)][band] - (value_at(place) != 0 ? 1 : 0);
  return others > 0 ? 0 : 4 + 0.05 * bands_[band].size;
}

double ClosedLoopRun::Bits::with(int value) const {
  if (around_) return (value == 0 ? 0 : waking_) + around_->bits(value);
  return RateTable::coarse_bits(value - before_) +
         (after_ ? RateTable::coarse_bits(*after_ - value) : 0);
}

void ClosedLoopRun::sweep_pairs(int reach) {
  // Moves change the gradient of all channels. It is kept only of those that the pairs of a few
  // channels are about, and looked up again for the next few.
  constexpr int kGroup = 12;
  Eigen::MatrixXf gradient(gradient_.size(), errors_.cols());
  for (int first = 0; first < channels(); first += kGroup) {
    const ErrorModel::ChannelRange looked_at{.first = first,
                                             .end = std::min(channels(), first + kGroup + reach)};
    pass(looked_at, [&](int j) { gradient.col(j) = gradient_; });
    for (int a = first; a < std::min(channels(), first + kGroup); ++a)
      for (int b = a + 1; b <= std::min(channels() - 1, a + reach); ++b)
        if (loop_.model_.are_related(a, b)) sweep_pair(a, b, {a, looked_at.end}, gradient);
  }
}

void ClosedLoopRun::sweep_pair(int a, int b, const ErrorModel::ChannelRange& looked_at,
                               Eigen::MatrixXf& gradient) {
  Eigen::ArrayXf entry = Eigen::ArrayXf::Zero(gradient.rows());
  entry.head(errors_.rows()) = loop_.model_.entry(a, b);
  for (int band = 1; band < static_cast<int>(bands_.size()); ++band)
    for (int i = 0; i < bands_[static_cast<std::size_t>(band)].size; ++i) {
      const int c = bands_[static_cast<std::size_t>(band)].first + i;
      if (coded_.values(c, a) == 0 && coded_.values(c, b) == 0) continue;
      const ShortFunction function = loop_.functions_[c];
      const auto place_in = [&](int j) {
        return place_of(j, band, i, step_in(j, band), function.dot(gradient.col(j).data()));
      };
      const Place in_a = place_in(a);
      const Place in_b = place_in(b);
      const double cross =
          in_a.step * in_b.step * static_cast<double>(function.dot_of_squares(entry.data()));
      if (!may_pay(in_a, in_b, cross)) continue;
      const auto [by_a, by_b] = best_moves(in_a, in_b, cross);
      move_of_pair(in_a, by_a, looked_at, gradient);
      move_of_pair(in_b, by_b, looked_at, gradient);
    }
}

double ClosedLoopRun::error_of(const Place& a, int by_a, const Place& b, int by_b, double cross) {
  return by_a * (2 * a.slope + by_a * a.curve) + by_b * (2 * b.slope + by_b * b.curve) +
         2 * by_a * by_b * cross;
}

bool ClosedLoopRun::may_pay(const Place& a, const Place& b, double cross) const {
  constexpr double kMostBits = 8;  // that moves by a step can well save
  for (const int by_a : {-1, 1})
    for (const int by_b : {-1, 1})
      if (error_of(a, by_a, b, by_b, cross) < kMostBits * lambda()) return true;
  return false;
}

std::pair<int, int> ClosedLoopRun::best_moves(const Place& a, const Place& b, double cross) const {
  std::array<double, 3> bits_of_a;
  std::array<double, 3> bits_of_b;
  const Bits with_a(*this, a);
  const Bits with_b(*this, b);
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

void ClosedLoopRun::move_of_pair(const Place& place, int steps,
                                 const ErrorModel::ChannelRange& looked_at,
                                 Eigen::MatrixXf& gradient) {
  if (steps == 0 || std::abs(value_at(place) + steps) > kMostSteps) return;
  const int j = place.channel;
  const Eigen::Index first = place.function.first();
  const Eigen::ArrayXf delta = static_cast<float>(steps * place.step) * place.function.values();
  energy_ += energy_of(j, first, gradient.col(j).segment(first, delta.size()).array(), delta);
  errors_.col(j).segment(first, delta.size()).array() += delta;
  loop_.model_.add_to_gradient(j, first, delta, looked_at, gradient);
  set(place, value_at(place) + steps);
}

}  // namespace mocapress
