// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

/// When a point counts as planted. Two thresholds each, so that a foot does not flicker: contact
/// begins below the first and ends above the second.
struct ContactSettings {
  double begin_height = 2.5;   // cm above the lowest the point comes to
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

/// The contacts of `count` frames from `first` on, which become frame 0 and so on.
std::vector<ContactSpan> frames_of(const std::vector<ContactSpan>& contacts, int first, int count);

/// The height (cm) a landmark rests at: low, but not so low as a glitch. `tracks` as
/// landmark_tracks() gives them, y up.
double ground_height(const Eigen::MatrixXd& tracks, int landmark);

/// Contact spans of the landmarks, by height and speed with hysteresis, in the order of `landmarks`
/// and then of time. Found on the original: data from then on, to be edited as one likes.
std::vector<ContactSpan> find_contacts(const Eigen::MatrixXd& tracks, double sample_rate_hz,
                                       const std::vector<int>& landmarks,
                                       const ContactSettings& settings = {});

/// The same for the feet of a skeleton, as find_feet() finds them. None where there are no feet.
std::vector<ContactSpan> find_foot_contacts(const Skeleton& skeleton, const Eigen::MatrixXd& tracks,
                                            double sample_rate_hz,
                                            const ContactSettings& settings = {});

/// The same of a motion: of its landmarks only those of the feet are ever all in memory.
std::vector<ContactSpan> find_foot_contacts(const Motion& motion,
                                            const ContactSettings& settings = {});

}  // namespace mocapress
