// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/base/instruction_sets.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// Trembling of a clip's joints above 10 Hz (Butterworth, fourth order), window by window. Its
/// tracks arrive in blocks of frames, in order and without gaps.
class Jitter {
 public:
  static constexpr double kAboveHz = 10;

  /// The last window also takes the remaining frames.
  Jitter(int joints, int windows, int window_frames, double sample_rate_hz);

  /// True if a sample rate carries frequencies above 10 Hz. If not, add() does nothing.
  static bool is_defined(double sample_rate_hz) { return sample_rate_hz > 2 * kAboveHz; }

  /// Adds rows of tracks whose first columns are the joints' origins.
  void add(int first_frame, const TrackRows& tracks);

  /// Squared distance of a joint from its smooth path (cm^2), summed over a window's frames:
  /// windows x joints.
  const Eigen::MatrixXf& squares() const { return squares_; }

  /// The sum of all squared accelerations above 10 Hz, (cm/s^2)^2.
  double energy() const { return energy_; }

 private:
  /// A filter section of second order.
  struct Section {
    Section(double sample_rate_hz, double quality);
    double b0, b1, b2, a1, a2;
  };

  /// Filter state of one joint: three coordinates side by side, and one lane unused.
  struct State {
    std::array<std::array<double, 4>, 4> delays;   // two for each section
    std::array<std::array<double, 4>, 2> outputs;  // the last output and the one before
  };

  /// Some rows of one joint's coordinates, and what they add to the sums of a window and of the
  /// clip.
  struct Stretch {
    std::array<const double*, 4> places;  // point to x, y, z and again z in the first row
    int rows;
    std::array<double, 4> squares{};
    std::array<double, 4> accelerations{};  // squared, per frame
  };

  State state_before(const TrackRows& tracks, Eigen::Index joint) const;
  void filter(State& state, Stretch& stretch) const;
  template <typename Vector>
  void filter_lanes(std::size_t lane, State& state, Stretch& stretch) const;
#ifdef MOCAPRESS_WITH_AVX2
  void filter_with_avx2(State& state, Stretch& stretch) const;
#endif

  int window_frames_;
  double sample_rate_hz_;
  std::array<Section, 2> sections_;
  std::vector<State> states_;  // one for each joint
  Eigen::MatrixXf squares_;
  double energy_ = 0;
};

}  // namespace mocapress
