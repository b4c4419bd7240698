// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "core/codec/encode/closed_loop_run.h"

namespace mocapress {

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
  for (int by = -1; by <= 1; ++by) {
    bits_of_a[static_cast<std::size_t>(by + 1)] = bits_with(a, significant_in_a, value_at(a) + by);
    bits_of_b[static_cast<std::size_t>(by + 1)] = bits_with(b, significant_in_b, value_at(b) + by);
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
