// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/feet/contact_spans.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// How far a foot that stands in the original moves in the decoded clip, in the mean of windows, so
/// that a foot that only trembles stands.
struct MovedContact {
  ContactSpan span;
  double slide_cm = 0;  // how much wider the ground is over which it moves than the original's
  double lift_cm = 0;   // how far above the original it comes

  bool operator==(const MovedContact&) const = default;
};

/// The same of a clip.
struct MovedContacts {
  double worst_slide_cm = 0;
  double worst_lift_cm = 0;

  bool operator==(const MovedContacts&) const = default;
};

/// Measures clips whose tracks come some frames at a time, in time and none left out.
class ContactsMeter {
 public:
  ContactsMeter(const std::vector<ContactSpan>& contacts, int window_frames);

  /// Rows of landmark_tracks() of both clips, from first_frame on.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// Once all are there: one a contact, in their order.
  std::vector<MovedContact> contacts() const;

 private:
  /// A rectangle on the ground.
  struct Ground {
    std::array<double, 2> low{};
    std::array<double, 2> high{};

    void widen(double x, double z, bool is_first);
    double width() const;
  };
  struct Standing {
    MovedContact moved;
    int windows = 0;                                     // that are finished
    int frames = 0;                                      // in the one that is not
    Eigen::Vector3d original = Eigen::Vector3d::Zero();  // sums over these, cm
    Eigen::Vector3d decoded = Eigen::Vector3d::Zero();
    Ground original_ground;
    Ground decoded_ground;
  };
  void finish_window(Standing& standing) const;

  int window_frames_;
  std::vector<Standing> standing_;
};

}  // namespace mocapress
