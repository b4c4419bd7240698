// SPDX-License-Identifier: MIT
#include "core/batch/worst_pose.h"

#include <cmath>
#include <limits>

#include "core/feet/contact_spans.h"
#include "core/report/markup.h"
#include "core/report/scene_svg.h"

namespace mocapress {
namespace {

double rounded(double cm) {
  return std::round(100 * cm) / 100;
}

void round_all(PosePoints& points) {
  for (Eigen::Vector3d& point : points) point = point.unaryExpr(&rounded).eval();
}

}  // namespace

PosePoints points_at(const TrackRows& tracks, int frame) {
  PosePoints points;
  for (Eigen::Index p = 0; p + 2 < tracks.cols(); p += 3)
    points.emplace_back(tracks.block<1, 3>(frame, p).transpose());
  return points;
}

double ground_of(const Eigen::MatrixXd& original_tracks) {
  double ground_cm = std::numeric_limits<double>::infinity();
  for (int landmark = 0; 3 * landmark < original_tracks.cols(); ++landmark)
    ground_cm = std::min(ground_cm, ground_height(original_tracks, landmark));
  return ground_cm;
}

WorstPose worst_pose(const Skeleton& skeleton, PosePoints original, PosePoints decoded,
                     double ground_cm, const WorstPoint& worst) {
  round_all(original);
  round_all(decoded);
  WorstPose pose{.frame = worst.frame,
                 .landmark = landmarks(skeleton)[worst.landmark].name,
                 .point = worst.landmark,
                 .off_cm = worst.cm,
                 .ground_cm = rounded(ground_cm),
                 .bones = figure_shape(skeleton),
                 .original = std::move(original),
                 .decoded = std::move(decoded)};
  for (DrawnBone& bone : pose.bones) {
    bone.from_radius = rounded(bone.from_radius);
    bone.to_radius = rounded(bone.to_radius);
  }
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
  // Shows the ground, too, unless that would make a figure high above it too small.
  low.y() = std::min(low.y(), std::max(pose.ground_cm, low.y() - 0.3 * (high - low).norm()));
  SceneSvg scene(picture, {.centre = (low + high) / 2,
                           .facing = pose.facing,
                           .height_cm = 1.15 * (high - low).norm(),
                           .width = 400,
                           .height = 400});
  scene.add_floor();
  scene.add_shadow(pose.decoded);
  scene.add_figure(pose.original, "ghost");
  scene.add_figure(pose.decoded, "figure");
  const auto point = static_cast<std::size_t>(pose.point);
  scene.add_gap(pose.original[point], pose.decoded[point], format_significant(pose.off_cm) + " cm");
  return scene.finish(label);
}

}  // namespace mocapress
