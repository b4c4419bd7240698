// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/slide_marks.h"

#include <algorithm>

#include "widgets/models/slide_colour.h"

namespace mocapress {
namespace {

constexpr float kStepPerRadius = 0.5f;  // shorter ways are drawn with the next

QVector3D onGround(const Eigen::MatrixXd& tracks, int frame, int landmark) {
  QVector3D point = landmarkAt(tracks, frame, landmark);
  point.setY(0);
  return point;
}

}  // namespace

std::vector<float> slideAlerts(const std::vector<SlideFinding>& slides, int joints, int frame) {
  std::vector<float> alerts(static_cast<std::size_t>(joints), 0.0f);
  for (const SlideFinding& slide : slides) {
    const ContactSpan& span = slide.span;
    if (frame < span.first_frame || frame > span.last_frame || span.landmark >= joints) continue;
    float& alert = alerts[static_cast<std::size_t>(span.landmark)];
    alert = std::max(alert, slideSeverity(slide.slid_cm));
  }
  return alerts;
}

std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius) {
  std::vector<Capsule> trails;
  for (const SlideFinding& slide : slides) {
    const ContactSpan& span = slide.span;
    const float alert = slideSeverity(slide.slid_cm);
    QVector3D start = onGround(tracks, span.first_frame, span.landmark);
    for (int t = span.first_frame + 1; t <= span.last_frame; ++t) {
      const QVector3D end = onGround(tracks, t, span.landmark);
      if (t < span.last_frame && start.distanceToPoint(end) < kStepPerRadius * radius) continue;
      trails.push_back({start, radius, end, radius, 0, alert});
      start = end;
    }
  }
  return trails;
}

}  // namespace mocapress
