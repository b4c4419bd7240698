// SPDX-License-Identifier: MIT
#include "core/contact/footskate.h"

#include <algorithm>
#include <cmath>

namespace mocapress {
namespace {

/// Horizontal way (cm) of a landmark from frame t - 1 to t.
double step(const Eigen::MatrixXd& tracks, int landmark, int t) {
  return std::hypot(tracks(t, 3 * landmark) - tracks(t - 1, 3 * landmark),
                    tracks(t, 3 * landmark + 2) - tracks(t - 1, 3 * landmark + 2));
}

}  // namespace

Footskate measure_footskate(const std::vector<ContactSpan>& contacts,
                            const Eigen::MatrixXd& original_tracks,
                            const Eigen::MatrixXd& decoded_tracks, double sample_rate_hz) {
  Footskate footskate;
  for (const ContactSpan& span : contacts) {
    SlideFinding finding{span, 0, 0, span.first_frame};
    for (int t = span.first_frame + 1; t <= span.last_frame; ++t) {
      const double way = step(decoded_tracks, span.landmark, t);
      finding.slid_cm += way - step(original_tracks, span.landmark, t);
      if (way * sample_rate_hz <= finding.worst_speed_cm_s) continue;
      finding.worst_speed_cm_s = way * sample_rate_hz;
      finding.worst_frame = t;
    }
    if (finding.slid_cm <= 0) continue;
    footskate.total_cm += finding.slid_cm;
    footskate.findings.push_back(finding);
  }
  std::stable_sort(
      footskate.findings.begin(), footskate.findings.end(),
      [](const SlideFinding& a, const SlideFinding& b) { return a.slid_cm > b.slid_cm; });
  return footskate;
}

}  // namespace mocapress
