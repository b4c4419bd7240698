// SPDX-License-Identifier: MIT
#include "core/report/picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/codec/methods/compression_method.h"
#include "core/feet/feet.h"
#include "core/motion/body.h"

namespace mocapress {

namespace {

constexpr double kThickness = 0.42;   // radius (cm) per square root of the carried length (cm)
constexpr double kLeastRadius = 0.9;  // cm
constexpr double kShortest = 0.1;     // cm: shorter limbs are not drawn
constexpr double kHeadWithoutTop =
    7;  // radius (cm) around a head's joint, for a head without a bone to its top

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool is_head(const Skeleton& skeleton, int joint) {
  return lower(skeleton.joint(joint).name).find("head") != std::string::npos;
}

double radius(double carried_length) {
  return std::max(kLeastRadius, kThickness * std::sqrt(carried_length));
}

/// For each joint, the total length (cm) of its own segments and of all segments below.
std::vector<double> carried_lengths(const Skeleton& skeleton) {
  std::vector<double> carried = skeleton.driven_lengths();
  for (int j = skeleton.joint_count() - 1; j > 0; --j)
    if (const int parent = skeleton.joint(j).parent; parent >= 0) carried[parent] += carried[j];
  return carried;
}

}  // namespace

std::vector<DrawnBone> figure_shape(const Skeleton& skeleton) {
  const std::vector<double> carried = carried_lengths(skeleton);
  std::vector<int> end_landmark(skeleton.joint_count(), -1);
  int landmark = skeleton.joint_count();
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (skeleton.joint(j).end_site) end_landmark[j] = landmark++;
  const int root = body_root(skeleton);
  std::vector<DrawnBone> bones;
  for (const Segment& segment : skeleton.segments()) {
    if (segment.length < kShortest || segment.joint < root) continue;
    const bool leaf = segment.child < 0;
    const int to = leaf ? end_landmark[segment.joint] : segment.child;
    const double beyond = leaf ? 0 : carried[segment.child];
    DrawnBone bone{segment.joint, to, radius(beyond + segment.length), 0};
    bone.to_radius = std::max(radius(beyond), 0.55 * bone.from_radius);
    if (beyond < kShortest) {
      if (is_head(skeleton, segment.joint)) {
        bone.from_radius = std::clamp(0.6 * segment.length, 5.5, 7.5);
        bone.to_radius = 1.1 * bone.from_radius;
      } else if (!leaf && is_head(skeleton, segment.child)) {
        bone.to_radius = kHeadWithoutTop;
      }
    }
    bones.push_back(bone);
  }
  return bones;
}

Eigen::Vector3d facing(const Skeleton& skeleton, const std::vector<Eigen::Vector3d>& points) {
  const std::vector<Effector> feet = find_feet(skeleton);
  if (feet.size() >= 2) {
    const auto hip = [&](const Effector& foot) { return points[foot.chain.front()]; };
    const Eigen::Vector3d forward = (hip(feet[0]) - hip(feet[1])).cross(Eigen::Vector3d::UnitY());
    if (forward.norm() > 1) return forward.normalized();
  }
  return Eigen::Vector3d::UnitZ();
}

std::string review_name(const Picture& picture, const std::string& method) {
  return picture.clip + ", " + std::string(method_title(method));
}

}  // namespace mocapress
