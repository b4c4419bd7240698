// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/joint_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

constexpr int kMostLanes = 8;
constexpr float kNone = std::numeric_limits<float>::infinity();
constexpr float kLeastGain = 1e-3F;  // bits

/// Adds to `sum` the amount by which slopes are beyond their limits.
template <typename Vector>
MOCAPRESS_INLINE void add_beyond(const Vector& slope, const Vector& low, const Vector& high,
                                 Vector& sum) {
  const Vector none{};
  sum += (slope > high ? slope - high : none) + (slope < low ? low - slope : none);
}

}  // namespace

JointSearch::JointSearch(std::span<const Coefficient> coefficients, const Eigen::MatrixXf& cross)
    : coefficients_(coefficients),
      cross_(cross),
      slopes_(Eigen::ArrayXf::Zero(rows_for(count()))),
      low_(Eigen::ArrayXf::Constant(slopes_.size(), -kNone)),
      high_(Eigen::ArrayXf::Constant(slopes_.size(), kNone)),
      moved_(coefficients.size()) {
  assert(cross.rows() == slopes_.size() && cross.cols() == count());
  for (int c = 0; c < count(); ++c) {
    slopes_(c) = coefficients[c].slope;
    set_limits(c);
  }
}

const std::vector<int>& JointSearch::run() {
  constexpr int kRounds = 2;
  int idle = 0;  // visits since the last gain; when all were visited without one, the search ends
  for (int round = 0; round < kRounds; ++round)
    for (int c = 0; c < count(); ++c) {
      if (++idle > count()) return moved_;
      if (has_avx2() ? visit_with_avx2(c) : visit<Floats4>(c)) idle = 0;
    }
  return moved_;
}

template <typename Vector>
MOCAPRESS_INLINE bool JointSearch::visit(int c) {
  bool gains = false;
  std::array<float, 2> of_answers = gains_of_answers<Vector>(c);
  for (const int by : {-1, 1}) {
    if (std::abs(moved_[c] + by) > 1) continue;
    if (cost_of(c, by) - of_answers[by > 0] >= -kLeastGain || !attempt<Vector>(c, by)) continue;
    gains = true;
    if (by < 0) of_answers = gains_of_answers<Vector>(c);
  }
  return gains;
}

#ifdef MOCAPRESS_WITH_AVX2
MOCAPRESS_FOR_AVX2 bool JointSearch::visit_with_avx2(int c) {
  return visit<Floats8>(c);
}
#else
bool JointSearch::visit_with_avx2(int c) {
  return visit<Floats4>(c);
}
#endif

template <typename Vector>
MOCAPRESS_INLINE bool JointSearch::attempt(int c, int by) {
  constexpr int kAnswers = 2;
  slopes_before_ = slopes_;
  changed_.clear();
  float cost = move<Vector>(c, by);
  for (int i = 0; i < kAnswers; ++i) {
    const float before = cost;
    for (int first = 0; first < count(); first += kLanes<Vector, float>)
      for (int other = next_beyond_limits<Vector>(first, first);
           other < first + kLanes<Vector, float>;
           other = next_beyond_limits<Vector>(first, other + 1)) {
        if (other == c) continue;
        if (slopes_(other) < low_(other)) cost += move<Vector>(other, 1);
        if (slopes_(other) > high_(other)) cost += move<Vector>(other, -1);
      }
    if (cost == before) break;
  }
  if (cost < -kLeastGain) return true;
  slopes_.swap(slopes_before_);
  for (; !changed_.empty(); changed_.pop_back()) {
    const auto [which, step] = changed_.back();
    moved_[which] -= step;
    set_limits(which);
  }
  return false;
}

template <typename Vector>
MOCAPRESS_INLINE float JointSearch::move(int c, int by) {
  const float cost = cost_of(c, by);
  const auto steps = static_cast<float>(by);
  moved_[c] += by;
  changed_.emplace_back(c, by);
  const float* const column = cross_.col(c).data();
  for (Eigen::Index i = 0; i < slopes_.size(); i += kLanes<Vector, float>) {
    Vector slope_of_others;
    Vector both;
    load(slopes_.data() + i, slope_of_others);
    load(column + i, both);
    store<Vector>(slope_of_others + steps * both, slopes_.data() + i);
  }
  set_limits(c);
  return cost;
}

MOCAPRESS_INLINE float JointSearch::cost_of(int c, int by) const {
  const auto& [slope, curve, prices] = coefficients_[c];
  const int moved = moved_[c];
  return 2 * static_cast<float>(by) * slopes_(c) + curve + prices[moved + by + 1] -
         prices[moved + 1];
}

template <typename Vector>
MOCAPRESS_INLINE std::array<float, 2> JointSearch::gains_of_answers(int c) const {
  constexpr int kParts = kMostLanes / kLanes<Vector, float>;
  Vector after_down[kParts] = {};
  Vector after_up[kParts] = {};
  const float* const column = cross_.col(c).data();
  for (Eigen::Index i = 0; i < slopes_.size(); i += kMostLanes)
    for (int part = 0; part < kParts; ++part) {
      const Eigen::Index first = i + part * kLanes<Vector, float>;
      Vector slope;
      Vector both;
      Vector low;
      Vector high;
      load(slopes_.data() + first, slope);
      load(column + first, both);
      load(low_.data() + first, low);
      load(high_.data() + first, high);
      add_beyond<Vector>(slope - both, low, high, after_down[part]);
      add_beyond<Vector>(slope + both, low, high, after_up[part]);
    }
  const auto gain = [&](const Vector* after, float own_slope) {
    std::array<float, kMostLanes> sums;
    std::memcpy(sums.data(), after, sizeof sums);
    float sum = 0;
    for (const float of_lane : sums) sum += of_lane;
    return 2 * (sum - std::max(own_slope - high_(c), 0.0F) - std::max(low_(c) - own_slope, 0.0F));
  };
  return {gain(after_down, slopes_(c) - column[c]), gain(after_up, slopes_(c) + column[c])};
}

MOCAPRESS_INLINE void JointSearch::set_limits(int c) {
  const auto& [slope, curve, prices] = coefficients_[c];
  const int moved = moved_[c];
  const auto saved_by = [moved, &prices = prices](int step) {  // clang 14 cannot capture a binding
    return prices[moved + 1] - prices[moved + step + 1];
  };
  low_(c) = moved < 1 ? (saved_by(1) - curve) / 2 : -kNone;
  high_(c) = moved > -1 ? (curve - saved_by(-1)) / 2 : kNone;
}

template <typename Vector>
MOCAPRESS_INLINE int JointSearch::next_beyond_limits(int first, int from) const {
  Vector slope;
  Vector low;
  Vector high;
  load(slopes_.data() + first, slope);
  load(low_.data() + first, low);
  load(high_.data() + first, high);
  const auto beyond = (slope < low) | (slope > high);
  // Tests two coefficients at a time; the 32 bits of each are all set or all clear.
  constexpr int kBits = 64;
  std::array<std::uint64_t, sizeof(Vector) / sizeof(std::uint64_t)> pairs;
  std::memcpy(pairs.data(), &beyond, sizeof beyond);
  const int passed = from - first;
  for (int pair = passed / 2; pair < static_cast<int>(pairs.size()); ++pair) {
    std::uint64_t bits = pairs[pair];
    if (2 * pair < passed) bits &= ~std::uint64_t{0} << (kBits / 2);
    if (bits != 0) return first + 2 * pair + (std::countr_zero(bits) >= kBits / 2 ? 1 : 0);
  }
  return first + kLanes<Vector, float>;
}

}  // namespace mocapress
