// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/ghost_trail.h"

#include <algorithm>
#include <cstdlib>

namespace mocapress {
namespace {

QColor between(const QColor& a, const QColor& b, float share) {
  const auto mixed = [share](float x, float y) { return x + share * (y - x); };
  return QColor::fromRgbF(mixed(a.redF(), b.redF()), mixed(a.greenF(), b.greenF()),
                          mixed(a.blueF(), b.blueF()));
}

}  // namespace

std::vector<int> TrailPoses::frames(int clip_frames) const {
  std::vector<int> at;
  const int before = (frame + step - 1) / step - 1;  // the last multiple before now
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
  const auto bones = static_cast<std::size_t>(shape.boneCount());
  const auto reach = static_cast<float>((poses.count + 1) * poses.step);
  std::vector<Capsule> trail;
  trail.reserve(frames.size() * bones);
  std::vector<Capsule> body(static_cast<std::size_t>(shape.capsuleCount()));
  FigureMarks marks;
  for (const int frame : frames) {
    const float away = static_cast<float>(std::abs(frame - poses.frame)) / reach;
    const QColor& near = frame < poses.frame ? colours.past : colours.future;
    marks.tints.assign(static_cast<std::size_t>(tracks.cols() / 3),
                       tintOf(between(near, colours.far, std::min(away, 1.0f))));
    shape.pose(tracks, frame, marks, body);
    trail.insert(trail.end(), body.end() - shape.boneCount(), body.end());
  }
  return trail;
}

}  // namespace mocapress
