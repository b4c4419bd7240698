// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "core/feet/contact_spans.h"
#include "core/motion/body_tracks.h"

namespace mocapress {

/// Movement in the decoded clip of a foot that stands in the original. It is measured on means of
/// windows, so a foot that only trembles stands still.
struct MovedContact {
  ContactSpan span;
  double slide_cm = 0;  // diagonal of the ground covered, beyond the original's
  double lift_cm = 0;   // largest height above the original

  bool operator==(const MovedContact&) const = default;
};

/// The largest values over a clip.
struct MovedContacts {
  double worst_slide_cm = 0;
  double worst_lift_cm = 0;

  bool operator==(const MovedContacts&) const = default;
};

/// Measures clips whose tracks arrive in blocks of frames, in order and without gaps.
class ContactsMeter {
 public:
  ContactsMeter(const std::vector<ContactSpan>& contacts, int window_frames);

  /// Adds rows of landmark_tracks() of both clips, starting at first_frame.
  void add(int first_frame, const TrackRows& original, const TrackRows& decoded);

  /// One result for each contact, in order, once all frames were added.
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
    int windows = 0;  // number of full windows
    int frames = 0;   // number of frames in the window being filled
    Eigen::Vector3d original = Eigen::Vector3d::Zero();  // sums over those frames, cm
    Eigen::Vector3d decoded = Eigen::Vector3d::Zero();
    Ground original_ground;
    Ground decoded_ground;
  };
  void finish_window(Standing& standing) const;

  int window_frames_;
  std::vector<Standing> standing_;
};

}  // namespace mocapress
