// SPDX-License-Identifier: MIT
// Based on: C. C. Lund and N. C. Browder, "The estimation of areas of burns", 1944 (whose skin is
// where); D. Du Bois and E. F. Du Bois, "A formula to estimate the approximate surface area", 1916;
// D. A. Winter, "Biomechanics and Motor Control of Human Movement" (legs in a stature).
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/motion/skeleton.h"

namespace mocapress {

enum class BodyRegion { Trunk, Neck, Head, UpperArm, Forearm, Hand, Thigh, LowerLeg, Foot };

/// The region of each joint's bones, told by the names of head, hands and feet and by what lies
/// between these and the trunk. Empty unless the skeleton has two arms and two legs.
std::vector<BodyRegion> body_regions(const Skeleton& skeleton);

/// The standing height (cm) of a figure with two arms and two legs, by the length of its legs.
/// Unset for other skeletons.
std::optional<double> stature(const Skeleton& skeleton);

/// The first joint that carries the body. A game's root on the floor does not: its only child moves
/// away from it. The landmarks of this joint and of those after it are the body's.
int body_root(const Skeleton& skeleton);

/// A stretch of body around a bone: a cylinder whose axis begins at a joint's origin.
struct BodyLimb {
  int joint;
  Eigen::Vector3d axis_in_joint;  // cm, from end to end
  double radius;                  // cm
  double share;                   // share of the body's surface
};

/// The body around a skeleton; its shares sum to 1. Each region of a human has a known share of the
/// surface. The region's bones divide it by their lengths, which gives their thickness. In other
/// skeletons every centimetre of bone has the same share. A last joint without an end site extends
/// the bone before it. No bone leads to a joint that slides on translation channels. A joint whose
/// turning would then move no bone gets a short one of its own. Empty if nothing has a length.
std::vector<BodyLimb> body_limbs(const Skeleton& skeleton);

}  // namespace mocapress
