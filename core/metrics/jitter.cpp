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

/// Filters the lanes from `lane` on over all rows, with the same operations for vectors of any
/// length.
template <typename Vector>
MOCAPRESS_INLINE void Jitter::filter_lanes(std::size_t lane, State& state, Stretch& stretch) const {
  constexpr std::size_t kCount = kLanes<Vector, double>;
  const Section& one = sections_[0];
  const Section& two = sections_[1];
  Vector delays[4];
  Vector last;
  Vector before;
  Vector squares;
  Vector accelerations;
  for (std::size_t i = 0; i < 4; ++i) load(state.delays[i].data() + lane, delays[i]);
  load(state.outputs[0].data() + lane, last);
  load(state.outputs[1].data() + lane, before);
  load(stretch.squares.data() + lane, squares);
  load(stretch.accelerations.data() + lane, accelerations);
  for (int t = 0; t < stretch.rows; ++t) {
    double coordinates[kCount];
    for (std::size_t k = 0; k < kCount; ++k) coordinates[k] = stretch.places[lane + k][t];
    Vector place;
    load(coordinates, place);
    const Vector middle = one.b0 * place + delays[0];
    delays[0] = one.b1 * place - one.a1 * middle + delays[1];
    delays[1] = one.b2 * place - one.a2 * middle;
    const Vector off = two.b0 * middle + delays[2];
    delays[2] = two.b1 * middle - two.a1 * off + delays[3];
    delays[3] = two.b2 * middle - two.a2 * off;
    squares += off * off;
    const Vector acceleration = off - 2 * last + before;
    accelerations += acceleration * acceleration;
    before = last;
    last = off;
  }
  for (std::size_t i = 0; i < 4; ++i) store(delays[i], state.delays[i].data() + lane);
  store(last, state.outputs[0].data() + lane);
  store(before, state.outputs[1].data() + lane);
  store(squares, stretch.squares.data() + lane);
  store(accelerations, stretch.accelerations.data() + lane);
}

#ifdef MOCAPRESS_WITH_AVX2
MOCAPRESS_FOR_AVX2 void Jitter::filter_with_avx2(State& state, Stretch& stretch) const {
  filter_lanes<Doubles4>(0, state, stretch);
}
#endif

void Jitter::filter(State& state, Stretch& stretch) const {
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) return filter_with_avx2(state, stretch);
#endif
  filter_lanes<Doubles2>(0, state, stretch);
  filter_lanes<Doubles2>(2, state, stretch);
}

/// The filter's state as if the joint had always moved at its first velocity.
Jitter::State Jitter::state_before(const TrackRows& tracks, Eigen::Index joint) const {
  const Section& s = sections_[0];
  State state{};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto track = tracks.col(3 * joint + axis);
    const double step = track.size() > 1 ? track(1) - track(0) : 0;
    const double before = track(0) - step;
    const auto lane = static_cast<std::size_t>(axis);
    state.delays[0][lane] = s.b1 * before + s.b2 * (before - step);
    state.delays[1][lane] = s.b2 * before;
  }
  return state;
}

void Jitter::add(int first_frame, const TrackRows& tracks) {
  if (!is_defined(sample_rate_hz_) || squares_.rows() == 0 || tracks.rows() == 0) return;
  const auto last_window = static_cast<int>(squares_.rows() - 1);
  const int end = first_frame + static_cast<int>(tracks.rows());
  double accelerations = 0;  // squared, per frame
  for (Eigen::Index joint = 0; joint < std::ssize(states_); ++joint) {
    State& state = states_[joint];
    const double* const x = tracks.col(3 * joint).data();
    const double* const y = tracks.col(3 * joint + 1).data();
    const double* const z = tracks.col(3 * joint + 2).data();
    if (first_frame == 0) state = state_before(tracks, joint);
    for (int t = first_frame; t < end;) {
      const int window = std::min(t / window_frames_, last_window);
      const int until = window == last_window ? end : std::min(end, (window + 1) * window_frames_);
      const int row = t - first_frame;
      Stretch stretch{.places = {x + row, y + row, z + row, z + row}, .rows = until - t};
      filter(state, stretch);
      const auto of_axes = [](const std::array<double, 4>& sums) {
        return sums[0] + sums[1] + sums[2];
      };
      squares_(window, joint) += static_cast<float>(of_axes(stretch.squares));
      accelerations += of_axes(stretch.accelerations);
      t = until;
    }
  }
  energy_ += accelerations * std::pow(sample_rate_hz_, 4);
}

}  // namespace mocapress
