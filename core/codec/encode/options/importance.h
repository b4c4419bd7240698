// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/motion/landmarks.h"

namespace mocapress {

struct ContactSpan;
struct PointResponse;

/// Parts of the motion that get more weight than eps_x gives them. Importance moves the error
/// elsewhere; reports and promises still use eps_x by its weighting.
struct Importance {
  // For each joint, by how much the weights of its landmarks are multiplied; empty: none.
  std::vector<double> joints;
  // Weight of a planted foot, as a multiple of its usual share; 0: no extra weight. Keeps the foot
  // planted without a correction.
  double contacts = 0;
  // Weight of the root's place and heading, as a share of the sum of all other weights; 0: no
  // weight of their own.
  double root = 0;

  bool is_even() const { return joints.empty() && contacts == 0 && root == 0; }
  bool operator==(const Importance&) const = default;
};

/// measured_points() with their weights multiplied by their joints' factors, and three points about
/// the root where it has a weight, scaled back to the same sum. Throws Error unless there is one
/// finite factor of 0 or more for each joint and some weight is left.
MeasuredPoints important_points(const Skeleton& skeleton, Weighting weighting,
                                const Importance& importance);

/// The points that stand and their extra weight while they do: one for each joint of the contacts.
std::vector<PointResponse> standing_points(const Skeleton& skeleton,
                                           const Eigen::MatrixXd& original_tracks,
                                           const std::vector<ContactSpan>& contacts,
                                           double importance);

/// Importance before the skeleton is known: by the names of body parts and joints.
struct NamedImportance {
  // Factors by body part ("feet" ...) or joint, in the order of set(). A joint's own factor takes
  // precedence over its part's.
  std::vector<std::pair<std::string, double>> factors;
  double contacts = 0;  // see Importance

  /// The factor of a name; 1 unless set.
  double factor(std::string_view name) const;
  void set(const std::string& name, double factor);

  bool is_even() const { return factors.empty() && contacts == 0; }
  bool operator==(const NamedImportance&) const = default;
};

bool is_body_part(std::string_view name);

/// The joints of a body part, or the one joint of that name; empty if there is none.
std::vector<int> joints_named(const Skeleton& skeleton, const std::string& name);

/// The importance for one skeleton. Body parts that it lacks are left out. Throws Error for a joint
/// that it lacks.
Importance importance_for(const NamedImportance& named, const Skeleton& skeleton);

/// The inverse of importance_for(). A part has the factor of the joint of the same name, or else
/// the one that most of its joints have. Joints with another factor are listed by name.
NamedImportance named(const Importance& importance, const Skeleton& skeleton);

}  // namespace mocapress
