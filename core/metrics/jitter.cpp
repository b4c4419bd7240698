// SPDX-License-Identifier: MIT
#include "core/metrics/jitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mocapress {

Jitter::Section::Section(double sample_rate_hz, double quality) {
  const double k = std::tan(std::numbers::pi * kAboveHz / sample_rate_hz);
  const double norm = 1 / (1 + k / quality + k * k);
  b0 = norm;
  b1 = -2 * norm;
  b2 = norm;
  a1 = 2 * (k * k - 1) * norm;
  a2 = (1 - k / quality + k * k) * norm;
}

Jitter::Jitter(int joints, int windows, int window_frames, double sample_rate_hz)
    : window_frames_(window_frames),
      sample_rate_hz_(sample_rate_hz),
      sections_{Section(sample_rate_hz, 0.54119610), Section(sample_rate_hz, 1.3065630)},
      states_(static_cast<std::size_t>(3 * joints)),
      squares_(Eigen::MatrixXf::Zero(windows, joints)) {}

double Jitter::filtered(double value, State& state) const {
  for (std::size_t i = 0; i < 2; ++i) {
    const Section& s = sections_[i];
    const double out = s.b0 * value + state.delays[2 * i];
    state.delays[2 * i] = s.b1 * value - s.a1 * out + state.delays[2 * i + 1];
    state.delays[2 * i + 1] = s.b2 * value - s.a2 * out;
    value = out;
  }
  return value;
}

/// As if it had moved as evenly for ever.
Jitter::State Jitter::state_before(double first, double step) const {
  const Section& s = sections_[0];
  const double before = first - step;
  return {{s.b1 * before + s.b2 * (before - step), s.b2 * before, 0, 0}, {}};
}

void Jitter::add(int first_frame, const TrackRows& tracks) {
  if (!is_defined(sample_rate_hz_) || squares_.rows() == 0 || tracks.rows() == 0) return;
  const Eigen::Index last_window = squares_.rows() - 1;
  double accelerations = 0;  // squared, per frame
  for (Eigen::Index c = 0; c < std::ssize(states_); ++c) {
    State& state = states_[static_cast<std::size_t>(c)];
    const auto places = tracks.col(c);
    if (first_frame == 0)
      state = state_before(places(0), places.size() > 1 ? places(1) - places(0) : 0);
    for (Eigen::Index t = 0; t < places.size(); ++t) {
      const double off = filtered(places(t), state);
      const double acceleration = off - 2 * state.outputs[0] + state.outputs[1];
      accelerations += acceleration * acceleration;
      state.outputs = {off, state.outputs[0]};
      squares_(std::min<Eigen::Index>((first_frame + t) / window_frames_, last_window), c / 3) +=
          static_cast<float>(off * off);
    }
  }
  energy_ += accelerations * std::pow(sample_rate_hz_, 4);
}

}  // namespace mocapress
