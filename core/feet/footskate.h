// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/feet/contact_spans.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// A contact during which the decoded foot slid further than the original.
struct SlideFinding {
  ContactSpan span;
  double slid_cm = 0;           // horizontal way from frame to frame, decoded minus original
  double drift_cm = 0;          // how far its error moved horizontally since the contact began
  double worst_speed_cm_s = 0;  // horizontal, of the decoded point
  int worst_frame = 0;
};

/// Footskate of a decoded clip: what it adds to the original's own sliding. The way sums every
/// step, so that trembling of a foot that stays in its place adds up; drift does not: it is how far
/// the foot gets from where it would be, had the error at the contact's first frame remained.
struct Footskate {
  double total_cm = 0;  // over all contacts; a contact that slid less than the original counts 0
  std::vector<SlideFinding> findings;  // one a contact that slid further, the worst first
  double drift_total_cm = 0;           // over all contacts, also those that slid no further
  double drift_worst_cm = 0;           // of one of them
};

/// Measures clips whose tracks come some frames at a time, in time and none left out.
class FootskateMeter {
 public:
  FootskateMeter(const std::vector<ContactSpan>& contacts, double sample_rate_hz);

  /// Rows of landmark_tracks() of both clips, from first_frame on.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// Once all are there.
  Footskate footskate() const;

 private:
  double sample_rate_hz_;
  std::vector<SlideFinding> findings_;         // one a contact, slid further or not
  std::vector<Eigen::Vector2d> first_errors_;  // of each contact: in its first frame, x and z
  Eigen::RowVectorXd last_original_;           // of the frames before
  Eigen::RowVectorXd last_decoded_;
};

/// Horizontal (x, z) way of each contact's landmark in the decoded clip and in the original, frame
/// to frame. Tracks as landmark_tracks() gives them, equal in shape.
Footskate measure_footskate(const std::vector<ContactSpan>& contacts,
                            const Eigen::MatrixXd& original_tracks,
                            const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz);

/// Footskate a contact. A total grows with the clip; these compare clips of any length.
struct SlidePerContact {
  double mean_cm = 0;   // over all contacts; one that slid no further than the original counts 0
  double worst_cm = 0;  // of the contact that slid furthest
  double drift_mean_cm = 0;
  double drift_worst_cm = 0;

  bool operator==(const SlidePerContact&) const = default;
};

/// Of footskate measured over so many contacts; unset without any.
std::optional<SlidePerContact> slide_per_contact(const Footskate& footskate, std::size_t contacts);

}  // namespace mocapress
