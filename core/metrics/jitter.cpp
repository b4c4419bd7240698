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
      states_(static_cast<std::size_t>(joints)),
      squares_(Eigen::MatrixXf::Zero(windows, joints)) {}

Jitter::Place Jitter::filtered(const Place& place, State& state) const {
  Place value = place;
  for (std::size_t i = 0; i < 2; ++i) {
    const Section& s = sections_[i];
    const Place out = s.b0 * value + state.delays[2 * i];
    state.delays[2 * i] = s.b1 * value - s.a1 * out + state.delays[2 * i + 1];
    state.delays[2 * i + 1] = s.b2 * value - s.a2 * out;
    value = out;
  }
  return value;
}

/// As if it had moved as evenly for ever.
Jitter::State Jitter::state_before(const Place& first, const Place& step) const {
  const Section& s = sections_[0];
  const Place before = first - step;
  const Place none = Place::Zero();
  return {{s.b1 * before + s.b2 * (before - step), s.b2 * before, none, none}, {none, none}};
}

void Jitter::add(int first_frame, const TrackRows& tracks) {
  if (!is_defined(sample_rate_hz_) || squares_.rows() == 0 || tracks.rows() == 0) return;
  const auto last_window = static_cast<int>(squares_.rows() - 1);
  const int end = first_frame + static_cast<int>(tracks.rows());
  double accelerations = 0;  // squared, per frame
  for (Eigen::Index joint = 0; joint < std::ssize(states_); ++joint) {
    State state = states_[static_cast<std::size_t>(joint)];
    const double* const x = tracks.col(3 * joint).data();
    const double* const y = tracks.col(3 * joint + 1).data();
    const double* const z = tracks.col(3 * joint + 2).data();
    const auto place = [&](int row) { return Place(x[row], y[row], z[row], 0); };
    if (first_frame == 0)
      state = state_before(place(0),
                           tracks.rows() > 1 ? Place(place(1) - place(0)) : Place(Place::Zero()));
    Place squared_accelerations = Place::Zero();
    for (int t = first_frame; t < end;) {
      const int window = std::min(t / window_frames_, last_window);
      const int until = window == last_window ? end : std::min(end, (window + 1) * window_frames_);
      Place squares = Place::Zero();
      for (; t < until; ++t) {
        const Place off = filtered(place(t - first_frame), state);
        squares += off.square();
        squared_accelerations += (off - 2 * state.outputs[0] + state.outputs[1]).square();
        state.outputs = {off, state.outputs[0]};
      }
      squares_(window, joint) += static_cast<float>(squares.sum());
    }
    accelerations += squared_accelerations.sum();
    states_[static_cast<std::size_t>(joint)] = state;
  }
  energy_ += accelerations * std::pow(sample_rate_hz_, 4);
}

}  // namespace mocapress
