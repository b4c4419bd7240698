// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/feet/contact_spans.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// A contact during which the decoded foot slid further than the original one.
struct SlideFinding {
  ContactSpan span;
  double slid_cm = 0;           // horizontal path length, decoded minus original
  double drift_cm = 0;          // largest horizontal change of the error since the contact began
  double worst_speed_cm_s = 0;  // horizontal, of the decoded point
  int worst_frame = 0;
};

/// Footskate of a decoded clip: the sliding beyond the original's own. The slid distance sums every
/// step, so trembling on the spot adds up. Drift does not add up: it is the largest distance of the
/// foot from where it would be if its error had stayed as in the contact's first frame.
struct Footskate {
  double total_cm = 0;  // over all contacts; one that slid less than in the original counts 0
  // One finding for each contact that slid further than in the original or drifted; the furthest
  // first.
  std::vector<SlideFinding> findings;
  double drift_total_cm = 0;  // over all contacts, whether they slid further or not
  double drift_worst_cm = 0;  // the largest of a single contact
};

/// Measures clips whose tracks arrive in blocks of frames, in order and without gaps.
class FootskateMeter {
 public:
  FootskateMeter(const std::vector<ContactSpan>& contacts, double sample_rate_hz);

  /// Adds rows of landmark_tracks() of both clips, starting at first_frame.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// The result, once all frames were added.
  Footskate footskate() const;

 private:
  double sample_rate_hz_;
  std::vector<SlideFinding> findings_;         // one for each contact, slid further or not
  std::vector<Eigen::Vector2d> first_errors_;  // each contact's error in its first frame, x and z
  Eigen::RowVectorXd last_original_;           // row before the present block
  Eigen::RowVectorXd last_decoded_;
};

/// Compares the horizontal (x, z) path of each contact's landmark in the decoded clip with the
/// original's, frame to frame. Tracks as from landmark_tracks(), equal in shape.
Footskate measure_footskate(const std::vector<ContactSpan>& contacts,
                            const Eigen::MatrixXd& original_tracks,
                            const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz);

/// Footskate per contact. Unlike a total, it can be compared between clips of different lengths.
struct SlidePerContact {
  double mean_cm = 0;   // over all contacts; one that slid no further than in the original counts 0
  double worst_cm = 0;  // largest of any contact
  double drift_mean_cm = 0;
  double drift_worst_cm = 0;

  bool operator==(const SlidePerContact&) const = default;
};

/// Footskate divided by the number of contacts; unset without contacts.
std::optional<SlidePerContact> slide_per_contact(const Footskate& footskate, std::size_t contacts);

}  // namespace mocapress
