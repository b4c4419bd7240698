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

std::vector<Capsule> footDiscs(const std::vector<ContactSpan>& contacts,
                               const std::vector<SlideFinding>& slides,
                               const Eigen::MatrixXd& tracks, int frame, float radius) {
  const auto slideOf = [&](const ContactSpan& span) {
    const auto found = std::find_if(slides.begin(), slides.end(),
                                    [&](const SlideFinding& slide) { return slide.span == span; });
    return found == slides.end() ? 0.0 : found->slid_cm;
  };
  std::vector<Capsule> discs;
  for (const ContactSpan& span : contacts) {
    if (frame < span.first_frame || frame > span.last_frame) continue;
    const QVector3D centre = onGround(tracks, frame, span.landmark);
    const QVector4D tint = tintOf(slideColour(slideOf(span)));
    discs.push_back({centre, radius, centre, radius, 0, 0, tint, tint});
  }
  return discs;
}

}  // namespace mocapress
