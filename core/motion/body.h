// SPDX-License-Identifier: MIT
// Based on: C. C. Lund and N. C. Browder, "The estimation of areas of burns", 1944 (whose skin is
// where); D. Du Bois and E. F. Du Bois, "A formula to estimate the approximate surface area", 1916;
// D. A. Winter, "Biomechanics and Motor Control of Human Movement" (legs in a stature).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

enum class BodyRegion { Trunk, Neck, Head, UpperArm, Forearm, Hand, Thigh, LowerLeg, Foot };

/// The region of each joint's bones, told by the names of head, hands and feet and by what lies
/// between these and the trunk. Empty where the skeleton has no two arms and two legs.
std::vector<BodyRegion> body_regions(const Skeleton& skeleton);

/// A stretch of body around a bone: a cylinder whose axis begins at a joint's origin.
struct BodyLimb {
  int joint;
  Eigen::Vector3d axis_in_joint;  // cm, from end to end
  double radius;                  // cm
  double share;                   // of the body's surface
};

/// The body around a skeleton, shares summing to 1. Each region of a human has its share of the
/// surface, divided among its bones by their lengths, and is as thick as that makes it. Elsewhere
/// every centimetre of bone has the same. A joint that drives no bone gets an extent along the bone
/// before it. What translates towards its parent ends no bone. Empty where nothing has a length.
std::vector<BodyLimb> body_limbs(const Skeleton& skeleton);

}  // namespace mocapress
