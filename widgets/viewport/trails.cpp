// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/trails.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "widgets/models/colours.h"

namespace mocapress {

namespace {

constexpr int kMostPieces = 30;  // on each side: a longer reach has longer pieces
constexpr float kThinnestTrail = 0.35f;

}  // namespace

std::vector<Capsule> jointPath(const Eigen::MatrixXd& tracks, int landmark, int frame, int reach,
                               float radius) {
  const int last = static_cast<int>(tracks.rows()) - 1;
  const int step = std::max(1, reach / kMostPieces);
  const auto radiusAt = [&](int t) {
    const float away = static_cast<float>(std::abs(t - frame)) / static_cast<float>(reach);
    return radius * (1 - (1 - kThinnestTrail) * away);
  };
  std::vector<Capsule> path;
  const auto add = [&](int a, int b) {
    path.push_back({landmarkAt(tracks, a, landmark), radiusAt(a), landmarkAt(tracks, b, landmark),
                    radiusAt(b), 0});
  };
  const int first = std::max(0, frame - reach);
  const int end = std::min(last, frame + reach);
  for (int t = frame; t > first; t -= step) add(t, std::max(t - step, first));
  for (int t = frame; t < end; t += step) add(t, std::min(t + step, end));
  return path;
}

namespace {

QColor between(const QColor& a, const QColor& b, float share) {
  const auto mixed = [share](float x, float y) { return x + share * (y - x); };
  return QColor::fromRgbF(mixed(a.redF(), b.redF()), mixed(a.greenF(), b.greenF()),
                          mixed(a.blueF(), b.blueF()));
}

}  // namespace

std::vector<int> TrailPoses::frames(int clip_frames) const {
  std::vector<int> at;
  const int before = (frame + step - 1) / step - 1;  // last multiple of the step before the frame
  for (int k = before - count + 1; k <= before; ++k)
    if (k >= 0) at.push_back(k * step);
  const int after = frame / step + 1;
  for (int k = after; k < after + count; ++k)
    if (k * step < clip_frames) at.push_back(k * step);
  return at;
}

std::vector<Capsule> ghostTrail(const FigureShape& shape, const Eigen::MatrixXd& tracks,
                                const TrailPoses& poses, const TrailColours& colours) {
  const std::vector<int> frames = poses.frames(static_cast<int>(tracks.rows()));
  const auto parts = static_cast<std::size_t>(shape.partCount());
  const auto reach = static_cast<float>((poses.count + 1) * poses.step);
  std::vector<Capsule> trail;
  trail.reserve(frames.size() * parts);
  std::vector<Capsule> body(static_cast<std::size_t>(shape.capsuleCount()));
  FigureMarks marks;
  for (const int frame : frames) {
    const float away = static_cast<float>(std::abs(frame - poses.frame)) / reach;
    const QColor& near = frame < poses.frame ? colours.past : colours.future;
    marks.tints.assign(static_cast<std::size_t>(tracks.cols() / 3),
                       tintOf(between(near, colours.far, std::min(away, 1.0f))));
    shape.pose(tracks, frame, marks, body);
    trail.insert(trail.end(), body.end() - shape.partCount(), body.end());
  }
  return trail;
}

namespace {

constexpr float kStepPerRadius = 0.5f;  // shorter pieces are joined with the next one

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
    alert = std::max(alert, slideSeverity(slide.drift_cm));
  }
  return alerts;
}

std::vector<Capsule> slideTrails(const std::vector<SlideFinding>& slides,
                                 const Eigen::MatrixXd& tracks, float radius) {
  std::vector<Capsule> trails;
  for (const SlideFinding& slide : slides) {
    const ContactSpan& span = slide.span;
    const float alert = slideSeverity(slide.drift_cm);
    QVector3D start = onGround(tracks, span.first_frame, span.landmark);
    for (int t = span.first_frame + 1; t <= span.last_frame; ++t) {
      const QVector3D end = onGround(tracks, t, span.landmark);
      if (t < span.last_frame && start.distanceToPoint(end) < kStepPerRadius * radius) continue;
      trails.push_back({start, radius, end, radius, alert});
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
    return found == slides.end() ? 0.0 : found->drift_cm;
  };
  std::vector<Capsule> discs;
  for (const ContactSpan& span : contacts) {
    if (frame < span.first_frame || frame > span.last_frame) continue;
    const QVector3D centre = onGround(tracks, frame, span.landmark);
    const QVector4D tint = tintOf(slideColour(slideOf(span)));
    discs.push_back({centre, radius, centre, radius, 0, tint, tint});
  }
  return discs;
}

}  // namespace mocapress
