// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/base/instruction_sets.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// How joints of one clip tremble above 10 Hz (Butterworth, fourth order), window by window. Its
/// tracks come some frames at a time, in time and none left out.
class Jitter {
 public:
  static constexpr double kAboveHz = 10;

  /// The last of the windows takes what frames are left over.
  Jitter(int joints, int windows, int window_frames, double sample_rate_hz);

  /// Whether a sample rate has frequencies above. add() does nothing where it has not.
  static bool is_defined(double sample_rate_hz) { return sample_rate_hz > 2 * kAboveHz; }

  /// Rows of tracks that begin with the joints' origins.
  void add(int first_frame, const TrackRows& tracks);

  /// Squares of what a joint is off its smooth way (cm^2), summed over a window's frames: windows x
  /// joints.
  const Eigen::MatrixXf& squares() const { return squares_; }

  /// The sum of all squared accelerations above 10 Hz, (cm/s^2)^2.
  double energy() const { return energy_; }

 private:
  /// Of second order.
  struct Section {
    Section(double sample_rate_hz, double quality);
    double b0, b1, b2, a1, a2;
  };

  /// Of one joint: its three coordinates side by side; one lane is left over.
  struct State {
    std::array<std::array<double, 4>, 4> delays;   // two of each section
    std::array<std::array<double, 4>, 2> outputs;  // the last and the one before
  };

  /// Some coordinates of a joint, and what they add to the sums of a window and of the clip.
  struct Stretch {
    std::array<const double*, 4> places;  // of the first row
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
  std::vector<State> states_;  // of joints
  Eigen::MatrixXf squares_;
  double energy_ = 0;
};

}  // namespace mocapress
