// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

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
  /// The three coordinates of a joint, side by side; one lane is left over.
  using Place = Eigen::Array4d;

  /// Of one joint.
  struct State {
    std::array<Place, 4> delays;
    std::array<Place, 2> outputs;  // the last and the one before
  };
  Place filtered(const Place& place, State& state) const;
  State state_before(const Place& first, const Place& step) const;

  int window_frames_;
  double sample_rate_hz_;
  std::array<Section, 2> sections_;
  std::vector<State> states_;  // of joints
  Eigen::MatrixXf squares_;
  double energy_ = 0;
};

}  // namespace mocapress
