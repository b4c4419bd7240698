// SPDX-License-Identifier: MIT
#include "core/feet/footskate.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

/// Horizontal distance (cm) of a landmark between two rows of tracks.
template <typename Row, typename Next>
double way(const Row& row, const Next& next, int landmark) {
  return std::hypot(next(3 * landmark) - row(3 * landmark),
                    next(3 * landmark + 2) - row(3 * landmark + 2));
}

/// Horizontal distance (cm) of a landmark between row t and the row before it. Row 0 follows
/// `last`.
double step(const Eigen::RowVectorXd& last, const TrackRows& tracks, int t, int landmark) {
  return t == 0 ? way(last, tracks.row(0), landmark)
                : way(tracks.row(t - 1), tracks.row(t), landmark);
}

/// Offset of a decoded landmark from the original one, in x and z.
Eigen::Vector2d error(const TrackRows& original, const TrackRows& decoded, int t, int landmark) {
  const auto along = [&](int axis) {
    return decoded(t, 3 * landmark + axis) - original(t, 3 * landmark + axis);
  };
  return {along(0), along(2)};
}

}  // namespace

FootskateMeter::FootskateMeter(const std::vector<ContactSpan>& contacts, double sample_rate_hz)
    : sample_rate_hz_(sample_rate_hz) {
  for (const ContactSpan& span : contacts)
    findings_.push_back({.span = span, .worst_frame = span.first_frame});
  first_errors_.assign(contacts.size(), Eigen::Vector2d::Zero());
}

void FootskateMeter::add(int first_frame, const TrackRows& original, const TrackRows& decoded) {
  const auto end = first_frame + static_cast<int>(decoded.rows());
  if (end == first_frame) return;
  for (std::size_t i = 0; i < findings_.size(); ++i) {
    SlideFinding& finding = findings_[i];
    const ContactSpan& span = finding.span;
    if (span.first_frame >= first_frame && span.first_frame < end)
      first_errors_[i] = error(original, decoded, span.first_frame - first_frame, span.landmark);
    for (int t = std::max(span.first_frame + 1, first_frame);
         t < std::min(span.last_frame + 1, end); ++t) {
      const double slid = step(last_decoded_, decoded, t - first_frame, span.landmark);
      const Eigen::Vector2d moved =
          error(original, decoded, t - first_frame, span.landmark) - first_errors_[i];
      finding.drift_cm = std::max(finding.drift_cm, moved.norm());
      finding.slid_cm += slid - step(last_original_, original, t - first_frame, span.landmark);
      if (slid * sample_rate_hz_ <= finding.worst_speed_cm_s) continue;
      finding.worst_speed_cm_s = slid * sample_rate_hz_;
      finding.worst_frame = t;
    }
  }
  last_original_ = original.bottomRows<1>();
  last_decoded_ = decoded.bottomRows<1>();
}

Footskate FootskateMeter::footskate() const {
  constexpr double kLeastDrift = 1e-3;  // cm; less is rounding
  Footskate footskate;
  for (const SlideFinding& finding : findings_) {
    footskate.drift_total_cm += finding.drift_cm;
    footskate.drift_worst_cm = std::max(footskate.drift_worst_cm, finding.drift_cm);
    if (finding.slid_cm <= 0 && finding.drift_cm < kLeastDrift) continue;
    footskate.findings.push_back(finding);
    double& slid_cm = footskate.findings.back().slid_cm;
    slid_cm = std::max(slid_cm, 0.0);
    footskate.total_cm += slid_cm;
  }
  std::ranges::stable_sort(footskate.findings, [](const SlideFinding& a, const SlideFinding& b) {
    return a.slid_cm > b.slid_cm;
  });
  return footskate;
}

Footskate measure_footskate(const std::vector<ContactSpan>& contacts,
                            const Eigen::MatrixXd& original_tracks,
                            const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz) {
  FootskateMeter meter(contacts, sample_rate_hz);
  meter.add(0, original_tracks, decoded_tracks);
  return meter.footskate();
}

std::optional<SlidePerContact> slide_per_contact(const Footskate& footskate, std::size_t contacts) {
  if (contacts == 0) return std::nullopt;
  return SlidePerContact{
      .mean_cm = footskate.total_cm / static_cast<double>(contacts),
      .worst_cm = footskate.findings.empty() ? 0 : footskate.findings.front().slid_cm,
      .drift_mean_cm = footskate.drift_total_cm / static_cast<double>(contacts),
      .drift_worst_cm = footskate.drift_worst_cm};
}

}  // namespace mocapress
