// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", section 3.1.

#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/motion/clip.h"

namespace mocapress {

struct Pose;
class PoseBlock;

/// A point fixed to a joint. Its path through the world is compared.
struct Landmark {
  int joint;
  Eigen::Vector3d in_joint;  // cm
  std::string name;          // the joint at the landmark, or "<joint> end"
};

std::vector<Landmark> joint_origins(const Skeleton& skeleton);

/// Every joint's origin (landmark j is joint j), then every end site.
std::vector<Landmark> landmarks(const Skeleton& skeleton);

/// The points that an error is measured on. The first two are readings of the paper's weights l_i /
/// l. The values are part of the file format.
enum class Weighting : std::uint8_t {
  BoneEnds = 0,      // a segment's far end carries its length: hands, feet and head count too
  JointOrigins = 1,  // a joint's origin carries the length of the segments it drives: the paper's
  Surface = 2,  // points on the body, which every turn of a joint moves: this is what people see
  Shell = 3,    // three points 3 cm from each joint, equally weighted: ACL's
  Skin = 4,     // points on a character's mesh, which must be present
};

inline constexpr std::initializer_list<Weighting> kWeightingsWithoutMesh = {
    Weighting::Surface, Weighting::Shell, Weighting::BoneEnds, Weighting::JointOrigins};
inline constexpr std::initializer_list<Weighting> kWeightings = {
    Weighting::Surface, Weighting::Skin, Weighting::Shell, Weighting::BoneEnds,
    Weighting::JointOrigins};

/// "bone-ends", "joint-origins", "surface", "shell", "skin".
std::string_view name(Weighting weighting);

/// One weight for each of landmarks(skeleton), summing to 1. Requires is_on_bones(weighting).
Eigen::VectorXd landmark_weights(const Skeleton& skeleton, Weighting weighting);

/// Writes the world positions of landmarks in one frame, or several, into rows of
/// landmark_tracks().
void place_landmarks(const std::vector<Landmark>& points, const Pose& pose, int frame,
                     Eigen::MatrixXd& tracks);
void place_landmarks(const std::vector<Landmark>& points, const PoseBlock& poses, int first,
                     int frames, Eigen::MatrixXd& tracks);

/// World positions (cm) of all landmarks over a clip: frames x 3 * landmarks, x y z of landmark 0
/// first. Frames are computed in parallel.
Eigen::MatrixXd landmark_tracks(const Skeleton& skeleton, const Clip& clip);

/// World positions (cm) of points of any kind over a clip, laid out like landmark_tracks().
Eigen::MatrixXd point_tracks(const Skeleton& skeleton, const std::vector<Landmark>& points,
                             const Clip& clip);

/// Points fixed to joints, and how much each counts. Weights sum to 1.
struct MeasuredPoints {
  std::vector<Landmark> points;
  Eigen::VectorXd weights;
};

inline constexpr double kShellRadius = 3;  // cm, ACL's radius for characters

/// The points of a weighting:
/// - on bones: landmarks(), weighted by landmark_weights();
/// - on the surface: surface_points(), whose error equals that of all the skin there;
/// - on the shell: three points for each joint, along its axes;
/// - on the skin: carried_points(); see require_measurable().
MeasuredPoints measured_points(const Skeleton& skeleton, Weighting weighting);

/// Throws Error if a weighting has no points on this skeleton.
void require_measurable(const Skeleton& skeleton, Weighting weighting);

/// True if a weighting measures landmarks() only.
constexpr bool is_on_bones(Weighting weighting) {
  return weighting == Weighting::BoneEnds || weighting == Weighting::JointOrigins;
}

/// Three points for each joint in turn, at kShellRadius along its axes.
std::vector<Landmark> shell_points(const Skeleton& skeleton);

}  // namespace mocapress
