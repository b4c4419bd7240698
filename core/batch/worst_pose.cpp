// SPDX-License-Identifier: MIT
#include "core/batch/worst_pose.h"

#include <cmath>
#include <limits>

#include "core/contact/contact_spans.h"
#include "core/study/markup.h"
#include "core/study/scene_svg.h"

namespace mocapress {
namespace {

double rounded(double cm) {
  return std::round(100 * cm) / 100;
}

PosePoints points_at(const Eigen::MatrixXd& tracks, int frame) {
  PosePoints points;
  for (Eigen::Index p = 0; p + 2 < tracks.cols(); p += 3) {
    const Eigen::Vector3d point = tracks.block<1, 3>(frame, p).transpose();
    points.push_back(point.unaryExpr(&rounded));
  }
  return points;
}

}  // namespace

WorstPose worst_pose(const Skeleton& skeleton, const Eigen::MatrixXd& original_tracks,
                     const Eigen::MatrixXd& decoded_tracks, const WorstPoint& worst) {
  WorstPose pose{.frame = worst.frame,
                 .landmark = landmarks(skeleton)[static_cast<std::size_t>(worst.landmark)].name,
                 .point = worst.landmark,
                 .bones = figure_shape(skeleton),
                 .original = points_at(original_tracks, worst.frame),
                 .decoded = points_at(decoded_tracks, worst.frame)};
  for (DrawnBone& bone : pose.bones) {
    bone.from_radius = rounded(bone.from_radius);
    bone.to_radius = rounded(bone.to_radius);
  }
  pose.ground_cm = std::numeric_limits<double>::infinity();
  for (int landmark = 0; 3 * landmark < original_tracks.cols(); ++landmark)
    pose.ground_cm = std::min(pose.ground_cm, ground_height(original_tracks, landmark));
  pose.ground_cm = rounded(pose.ground_cm);
  pose.facing = facing(skeleton, pose.original).unaryExpr(&rounded).normalized();
  return pose;
}

std::string worst_scene(const WorstPose& pose, const std::string& label) {
  Picture picture;
  picture.bones = pose.bones;
  picture.ground_cm = pose.ground_cm;
  Eigen::Vector3d low = pose.original.front();
  Eigen::Vector3d high = low;
  for (const Eigen::Vector3d& point : pose.original) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  low.y() = std::min(low.y(), pose.ground_cm);
  SceneSvg scene(picture, {.centre = (low + high) / 2,
                           .facing = pose.facing,
                           .height_cm = 1.15 * (high - low).norm(),
                           .width = 400,
                           .height = 400});
  scene.add_floor();
  scene.add_shadow(pose.decoded);
  scene.add_figure(pose.original, "ghost");
  scene.add_figure(pose.decoded, "figure");
  const Eigen::Vector3d& wanted = pose.original[static_cast<std::size_t>(pose.point)];
  const Eigen::Vector3d& found = pose.decoded[static_cast<std::size_t>(pose.point)];
  scene.add_gap(wanted, found, figure((wanted - found).norm()) + " cm");
  return scene.finish(label);
}

}  // namespace mocapress
