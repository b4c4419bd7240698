// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/figure_shape.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

// Thickness grows with the root of the length, so that neither fingers vanish nor thighs swell.
constexpr float kRadiusPerRoot = 0.034f;  // of length x size of the figure
constexpr float kThinnest = 0.003f;       // radius per size of the figure
constexpr float kTaper = 0.6f;            // a bone's end radius, per start radius
constexpr float kBallPerBone = 1.22f;     // a joint's ball, per thickest bone it starts
constexpr float kSelectedGrowth = 1.5f;

Eigen::MatrixXd restTracks(const Skeleton& skeleton) {
  Clip rest;
  rest.channels = Eigen::MatrixXd::Zero(1, skeleton.channel_count());
  return landmark_tracks(skeleton, rest);
}

/// The box around a frame's landmarks.
struct Box {
  QVector3D low, high;
};

Box boxAround(const Eigen::MatrixXd& tracks, int frame, int first) {
  Box box{landmarkAt(tracks, frame, first), landmarkAt(tracks, frame, first)};
  for (int p = first + 1; p < tracks.cols() / 3; ++p) {
    const QVector3D point = landmarkAt(tracks, frame, p);
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  }
  return box;
}

bool isMoved(const Joint& joint) {
  return std::any_of(joint.channels.begin(), joint.channels.end(),
                     [](ChannelKind kind) { return !is_rotation(kind); });
}

/// Joints come parents first: those above the body are the first ones.
int bodyRootOf(const Skeleton& skeleton) {
  std::vector<int> children(static_cast<std::size_t>(skeleton.joint_count()), 0);
  for (const Joint& joint : skeleton.joints())
    if (joint.parent >= 0) ++children[static_cast<std::size_t>(joint.parent)];
  int root = 0;
  while (root + 1 < skeleton.joint_count() && children[static_cast<std::size_t>(root)] == 1 &&
         skeleton.joint(root + 1).parent == root && isMoved(skeleton.joint(root + 1)))
    ++root;
  return root;
}

float longestSide(const Box& box) {
  const QVector3D sides = box.high - box.low;
  return std::max({sides.x(), sides.y(), sides.z()});
}

}  // namespace

QVector4D tintOf(const QColor& colour) {
  return {colour.redF(), colour.greenF(), colour.blueF(), 1};
}

QVector3D landmarkAt(const Eigen::MatrixXd& tracks, int frame, int landmark) {
  const auto at = [&](int axis) { return static_cast<float>(tracks(frame, 3 * landmark + axis)); };
  return {at(0), at(1), at(2)};
}

FigureShape::FigureShape(const Skeleton& skeleton)
    : ball_radii_(static_cast<std::size_t>(skeleton.joint_count())),
      body_root_(bodyRootOf(skeleton)) {
  size_ =
      skeleton.joint_count() > 0 ? longestSide(boxAround(restTracks(skeleton), 0, body_root_)) : 0;
  if (size_ <= 0) size_ = 100;  // a lone point is still drawn as a ball to see and to click
  std::fill(ball_radii_.begin(), ball_radii_.end(), kThinnest * size_);

  int end_site = skeleton.joint_count();
  for (const Segment& segment : skeleton.segments()) {
    const int end = segment.child >= 0 ? segment.child : end_site++;
    if (segment.length <= 0) continue;
    const float radius = std::max(
        kRadiusPerRoot * std::sqrt(static_cast<float>(segment.length) * size_), kThinnest * size_);
    bones_.push_back({segment.joint, end, radius});
    float& ball = ball_radii_[static_cast<std::size_t>(segment.joint)];
    ball = std::max(ball, kBallPerBone * radius);
  }
}

void FigureShape::pose(const Eigen::MatrixXd& tracks, int frame, const FigureMarks& marks,
                       std::span<Capsule> capsules) const {
  assert(static_cast<int>(capsules.size()) == capsuleCount());
  const auto alertOf = [&](int landmark) {  // landmark j is joint j
    const auto j = static_cast<std::size_t>(landmark);
    return j < marks.alerts.size() ? marks.alerts[j] : 0.0f;
  };
  const auto tintAt = [&](int landmark) {
    const auto p = static_cast<std::size_t>(landmark);
    return p < marks.tints.size() ? marks.tints[p] : QVector4D();
  };
  auto capsule = capsules.begin();
  for (int j = 0; j < jointCount(); ++j) {
    const bool selected = j == marks.selected_joint;
    const QVector3D centre = landmarkAt(tracks, frame, j);
    const float radius =
        ball_radii_[static_cast<std::size_t>(j)] * (selected ? kSelectedGrowth : 1);
    *capsule++ = {centre,     radius,    centre,   radius, selected ? 1.0f : 0.0f,
                  alertOf(j), tintAt(j), tintAt(j)};
  }
  for (const Bone& bone : bones_)
    *capsule++ = {landmarkAt(tracks, frame, bone.start),
                  bone.radius,
                  landmarkAt(tracks, frame, bone.end),
                  kTaper * bone.radius,
                  0,
                  std::max(alertOf(bone.start), alertOf(bone.end)),
                  tintAt(bone.start),
                  tintAt(bone.end)};
}

std::vector<QVector3D> FigureShape::body(const Eigen::MatrixXd& tracks, int frame) const {
  std::vector<QVector3D> points;
  for (int p = body_root_; p < tracks.cols() / 3; ++p)
    points.push_back(landmarkAt(tracks, frame, p));
  return points;
}

QVector3D FigureShape::centre(const Eigen::MatrixXd& tracks, int frame) const {
  const Box box = boxAround(tracks, frame, body_root_);
  return (box.low + box.high) / 2;
}

}  // namespace mocapress
