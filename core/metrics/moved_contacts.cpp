// SPDX-License-Identifier: MIT
#include "core/metrics/moved_contacts.h"

#include <algorithm>
#include <cmath>

namespace mocapress {

void ContactsMeter::Ground::widen(double x, double z, bool is_first) {
  const std::array<double, 2> at = {x, z};
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = is_first ? at[i] : std::min(low[i], at[i]);
    high[i] = is_first ? at[i] : std::max(high[i], at[i]);
  }
}

double ContactsMeter::Ground::width() const {
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

ContactsMeter::ContactsMeter(const std::vector<ContactSpan>& contacts, int window_frames)
    : window_frames_(window_frames) {
  for (const ContactSpan& span : contacts) standing_.push_back({.moved = {.span = span}});
}

void ContactsMeter::finish_window(Standing& standing) const {
  const Eigen::Vector3d original = standing.original / standing.frames;
  const Eigen::Vector3d decoded = standing.decoded / standing.frames;
  const bool is_first = standing.windows == 0;
  standing.original_ground.widen(original.x(), original.z(), is_first);
  standing.decoded_ground.widen(decoded.x(), decoded.z(), is_first);
  standing.moved.lift_cm = std::max(standing.moved.lift_cm, decoded.y() - original.y());
  standing.moved.slide_cm =
      std::max(0.0, standing.decoded_ground.width() - standing.original_ground.width());
  ++standing.windows;
  standing.frames = 0;
  standing.original.setZero();
  standing.decoded.setZero();
}

void ContactsMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  const auto end = first_frame + static_cast<int>(decoded.rows());
  for (Standing& standing : standing_) {
    const ContactSpan& span = standing.moved.span;
    const Eigen::Index column = Eigen::Index{3} * span.landmark;
    const int windows = std::max(1, span.frames() / window_frames_);
    for (int t = std::max(span.first_frame, first_frame); t < std::min(span.last_frame + 1, end);
         ++t) {
      const Eigen::Index row = t - first_frame;
      standing.original += original.block<1, 3>(row, column).transpose();
      standing.decoded += decoded.block<1, 3>(row, column).transpose();
      ++standing.frames;
      const bool is_full =
          // A full window that is not the last.
          standing.windows + 1 < windows && standing.frames == window_frames_;
      if (is_full || t == span.last_frame) finish_window(standing);
    }
  }
}

std::vector<MovedContact> ContactsMeter::contacts() const {
  std::vector<MovedContact> moved;
  for (const Standing& standing : standing_) moved.push_back(standing.moved);
  return moved;
}

}  // namespace mocapress
