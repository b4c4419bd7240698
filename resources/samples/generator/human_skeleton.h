// SPDX-License-Identifier: MIT
// Based on: Drillis & Contini, "Body Segment Parameters", 1966, as printed in Winter, "Biomechanics
// and Motor Control of Human Movement", 4th ed. 2009, figure 4.1: segment lengths as shares of
// stature.
#pragma once

#include <Eigen/Core>
#include <string>

#include "core/motion/skeleton.h"

namespace mocapress::samples {

inline constexpr double kStature = 175;  // cm

/// Acclaim's bones and degrees of freedom (6 + 56). At rest the figure stands upright, arms at its
/// sides: x to its left, y up, z ahead.
Skeleton human_skeleton();

enum class Side { Left, Right };

/// "lfemur", "rfemur".
std::string sided(Side side, const std::string& bone);

/// A vector or angles given for the left side, as they are on `side`.
Eigen::Vector3d mirrored_offset(Side side, const Eigen::Vector3d& left);
Eigen::Vector3d mirrored_angles(Side side, const Eigen::Vector3d& left);

inline constexpr double kThighLength = 0.245 * kStature;  // cm
inline constexpr double kShankLength = 0.246 * kStature;
inline constexpr double kAnkleHeight = 0.039 * kStature;
inline constexpr double kStandingRootHeight = 0.570 * kStature;

/// The left hip joint in the root's frame (cm).
inline const Eigen::Vector3d kHipInRoot{0.050 * kStature, -0.040 * kStature, 0};

/// Where the sole touches the floor (cm): the heel and the ball in the foot's frame, the ball and
/// the tip in that of the toes, whose origin is kBallJointInFoot.
inline const Eigen::Vector3d kBallJointInFoot{0, -0.027 * kStature, 0.078 * kStature};
inline const Eigen::Vector3d kHeelInFoot{0, -kAnkleHeight, -0.030 * kStature};
inline const Eigen::Vector3d kBallInToes{0, -0.012 * kStature, 0};
inline const Eigen::Vector3d kTipInToes{0, -0.012 * kStature, 0.044 * kStature};

}  // namespace mocapress::samples
