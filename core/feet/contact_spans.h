// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// Thresholds at which a point counts as planted. There are two for each quantity, so that a foot
/// does not flicker: contact begins below the first and ends above the second.
struct ContactSettings {
  double begin_height = 2.5;   // cm above the point's lowest height
  double end_height = 4.0;     // cm
  double begin_speed = 30.0;   // cm/s
  double end_speed = 50.0;     // cm/s
  double least_seconds = 0.1;  // shorter spans are dropped, shorter gaps closed

  bool operator==(const ContactSettings&) const = default;
};

/// A landmark on the ground from first_frame to last_frame, both included.
struct ContactSpan {
  int landmark = 0;
  int first_frame = 0;
  int last_frame = 0;

  int frames() const { return last_frame - first_frame + 1; }
  bool operator==(const ContactSpan&) const = default;
};

/// The contacts within `count` frames from `first` on, renumbered so that `first` is frame 0.
std::vector<ContactSpan> frames_of(const std::vector<ContactSpan>& contacts, int first, int count);

/// The height (cm) at which a landmark rests: its 2nd percentile, so that single glitches do not
/// count. `tracks` as from landmark_tracks(), y up.
double ground_height(const Eigen::MatrixXd& tracks, int landmark);

/// Contact spans of landmarks, by height and speed with hysteresis, in the order of `landmarks` and
/// then of time. They are found on the original; afterwards they are plain data that users may
/// edit.
std::vector<ContactSpan> find_contacts(const Eigen::MatrixXd& tracks, double sample_rate_hz,
                                       const std::vector<int>& landmarks,
                                       const ContactSettings& settings = {});

/// Contact spans of the feet that find_feet() finds in a skeleton; empty if it finds none.
std::vector<ContactSpan> find_foot_contacts(const Skeleton& skeleton, const Eigen::MatrixXd& tracks,
                                            double sample_rate_hz,
                                            const ContactSettings& settings = {});

/// Contact spans of a motion's feet. Computes tracks of the feet's landmarks only.
std::vector<ContactSpan> find_foot_contacts(const Motion& motion,
                                            const ContactSettings& settings = {});

}  // namespace mocapress
