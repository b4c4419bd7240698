// SPDX-License-Identifier: MIT
#include "core/motion/landmarks.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/pose_block.h"
#include "core/motion/skin_points.h"
#include "core/motion/surface_points.h"

namespace mocapress {

std::vector<Landmark> joint_origins(const Skeleton& skeleton) {
  std::vector<Landmark> all;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    all.push_back({j, Eigen::Vector3d::Zero(), skeleton.joint(j).name});
  return all;
}

std::vector<Landmark> landmarks(const Skeleton& skeleton) {
  std::vector<Landmark> all = joint_origins(skeleton);
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (const auto& end = skeleton.joint(j).end_site)
      all.push_back({j, *end, skeleton.joint(j).name + " end"});
  return all;
}

std::string_view name(Weighting weighting) {
  switch (weighting) {
    case Weighting::BoneEnds:
      return "bone-ends";
    case Weighting::JointOrigins:
      return "joint-origins";
    case Weighting::Surface:
      return "surface";
    case Weighting::Shell:
      return "shell";
    case Weighting::Skin:
      return "skin";
  }
  return "unknown";
}

Eigen::VectorXd landmark_weights(const Skeleton& skeleton, Weighting weighting) {
  const std::vector<Landmark> points = landmarks(skeleton);
  std::vector<int> end_site_landmark(skeleton.joint_count(), -1);
  for (int p = skeleton.joint_count(); p < static_cast<int>(points.size()); ++p)
    end_site_landmark[points[p].joint] = p;

  Eigen::VectorXd weights = Eigen::VectorXd::Zero(points.size());
  for (const Segment& segment : skeleton.segments()) {
    const int far_end = segment.child >= 0 ? segment.child : end_site_landmark[segment.joint];
    weights(weighting == Weighting::BoneEnds ? far_end : segment.joint) += segment.length;
  }
  // A skeleton without length (one joint, no end site) still has a position to compare.
  if (weights.sum() <= 0) weights.setOnes();
  return weights / weights.sum();
}

void place_landmarks(const std::vector<Landmark>& points, const Pose& pose, int frame,
                     Eigen::MatrixXd& tracks) {
  for (std::size_t p = 0; p < points.size(); ++p)
    tracks.block<1, 3>(frame, 3 * static_cast<Eigen::Index>(p)) =
        pose.to_world(points[p].joint, points[p].in_joint).transpose();
}

void place_landmarks(const std::vector<Landmark>& points, const PoseBlock& poses, int first,
                     int frames, Eigen::MatrixXd& tracks) {
  for (std::size_t p = 0; p < points.size(); ++p)
    for (Eigen::Index i = 0; i < 3; ++i) {
      auto track = tracks.col(3 * static_cast<Eigen::Index>(p) + i).segment(first, frames).array();
      if (points[p].in_joint.isZero(0))
        track = poses.origin(points[p].joint).col(i);
      else
        track = poses.place(points[p].joint, points[p].in_joint).col(i);
    }
}

Eigen::MatrixXd landmark_tracks(const Skeleton& skeleton, const Clip& clip) {
  return point_tracks(skeleton, landmarks(skeleton), clip);
}

Eigen::MatrixXd point_tracks(const Skeleton& skeleton, const std::vector<Landmark>& points,
                             const Clip& clip) {
  Eigen::MatrixXd tracks(clip.frames(), 3 * static_cast<Eigen::Index>(points.size()));
  visit_poses(skeleton, clip.channels, [&](const PoseBlock& poses, int first, int frames) {
    place_landmarks(points, poses, first, frames, tracks);
  });
  return tracks;
}

namespace {

MeasuredPoints evenly(std::vector<Landmark> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  return {std::move(points),
          Eigen::VectorXd::Constant(count,
                                    1.0 / static_cast<double>(std::max<Eigen::Index>(count, 1)))};
}

}  // namespace

std::vector<Landmark> shell_points(const Skeleton& skeleton) {
  std::vector<Landmark> points;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    for (int axis = 0; axis < 3; ++axis)
      points.push_back({j, kShellRadius * Eigen::Vector3d::Unit(axis), skeleton.joint(j).name});
  return points;
}

void require_measurable(const Skeleton& skeleton, Weighting weighting) {
  if (weighting == Weighting::Skin && !skeleton.skin())
    throw Error(
        "the weighting skin needs a clip with a mesh on its joints, or a character that is put on "
        "it");
}

MeasuredPoints measured_points(const Skeleton& skeleton, Weighting weighting) {
  if (is_on_bones(weighting)) return {landmarks(skeleton), landmark_weights(skeleton, weighting)};
  if (weighting == Weighting::Skin) {
    require_measurable(skeleton, weighting);
    return carried_points(*skeleton.skin(), skeleton);
  }
  if (weighting == Weighting::Surface) return surface_points(skeleton);
  return evenly(shell_points(skeleton));
}

}  // namespace mocapress
