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

/// Parts of the motion that get more weight than eps_x gives them. Importance moves errors to other
/// parts; reports and promises still use eps_x without importance.
struct Importance {
  // For each joint, the factor of its landmarks' weights; empty: 1 for all.
  std::vector<double> joints;
  // Extra weight of a planted foot, as a multiple of an average joint's; 0: none. Keeps the foot
  // planted without a correction.
  double contacts = 0;
  // Weight of the root's place and heading, as a share of the sum of all other weights; 0: no
  // weight of their own.
  double root = 0;

  bool is_even() const { return joints.empty() && contacts == 0 && root == 0; }
  bool operator==(const Importance&) const = default;
};

/// Returns measured_points() with weights multiplied by their joints' factors, and three more
/// points that turn with the root if it has a weight. The weights are scaled to a sum of 1. Throws
/// Error unless there is one finite factor of 0 or more for each joint and some weight is left.
MeasuredPoints important_points(const Skeleton& skeleton, Weighting weighting,
                                const Importance& importance);

/// For each joint that has contacts, its place and its extra weight during them.
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

/// The importance for one skeleton. Body parts that the skeleton lacks are left out. Throws Error
/// for a joint that it lacks.
Importance importance_for(const NamedImportance& named, const Skeleton& skeleton);

/// The inverse of importance_for(). A part has the factor of the joint of the same name, or else
/// the one that most of its joints have. Joints with another factor are listed by name.
NamedImportance named(const Importance& importance, const Skeleton& skeleton);

}  // namespace mocapress
