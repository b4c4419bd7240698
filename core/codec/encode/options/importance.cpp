// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/importance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/feet/contact_spans.h"
#include "core/motion/body_part.h"
#include "core/select/point_term.h"

namespace mocapress {

namespace {

void weigh_joints(const std::vector<double>& factors, int joint_count, MeasuredPoints& measured) {
  if (std::ssize(factors) != joint_count)
    throw Error("the importance of every joint is needed, or of none");
  for (const double factor : factors)
    if (!std::isfinite(factor) || factor < 0)
      throw Error("the importance of a joint must be a number, 0 or more");
  Eigen::VectorXd& weights = measured.weights;
  for (Eigen::Index p = 0; p < weights.size(); ++p) {
    const auto joint = measured.points[p].joint;
    weights(p) *= factors[joint];
  }
  if (weights.sum() <= 0) throw Error("no joint is of any importance");
}

/// Adds three points that turn with the root, so far from it that a turn by 0.3 degrees moves one
/// by 2 mm.
void add_root(double weight, MeasuredPoints& measured) {
  constexpr double kDistance = 38;  // cm
  const Eigen::Index before = measured.weights.size();
  const double each = weight * measured.weights.sum() / 3;
  measured.weights.conservativeResize(before + 3);
  for (int axis = 0; axis < 3; ++axis) {
    measured.points.push_back({0, kDistance * Eigen::Vector3d::Unit(axis), "root"});
    measured.weights(before + axis) = each;
  }
}

}  // namespace

MeasuredPoints important_points(const Skeleton& skeleton, Weighting weighting,
                                const Importance& importance) {
  MeasuredPoints measured = measured_points(skeleton, weighting);
  if (!importance.joints.empty()) weigh_joints(importance.joints, skeleton.joint_count(), measured);
  if (importance.root > 0) add_root(importance.root, measured);
  measured.weights /= measured.weights.sum();
  return measured;
}

std::vector<PointResponse> standing_points(const Skeleton& skeleton,
                                           const Eigen::MatrixXd& original_tracks,
                                           const std::vector<ContactSpan>& contacts,
                                           double importance) {
  // The share is the same for all joints, so that a foot whose joint has no weight of its own
  // counts too.
  const double share = 1.0 / std::max(skeleton.joint_count(), 1);
  std::map<int, PointResponse> points;
  for (const ContactSpan& span : contacts) {
    if (span.landmark >= skeleton.joint_count()) continue;  // the end of a bone, not a joint
    PointResponse& point = points[span.landmark];
    if (point.joints.empty()) {
      point.joints = {span.landmark};
      point.places = original_tracks.middleCols(3 * Eigen::Index{span.landmark}, 3);
      point.turns.resize(original_tracks.rows(), 0);
      point.weights = Eigen::MatrixXd::Zero(original_tracks.rows(), 1);
    }
    point.weights.middleRows(span.first_frame, span.frames()).setConstant(importance * share);
  }
  std::vector<PointResponse> all;
  for (auto& [joint, point] : points) all.push_back(std::move(point));
  return all;
}

namespace {

/// The factor that most joints have; the smallest in case of a tie.
double usual_factor(const std::vector<double>& factors, const std::vector<int>& joints) {
  std::map<double, int> counts;
  for (const int joint : joints) ++counts[factors[joint]];
  return std::ranges::max_element(counts,
                                  [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

double NamedImportance::factor(std::string_view name) const {
  const auto found =
      std::ranges::find_if(factors, [&](const auto& one) { return one.first == name; });
  return found == factors.end() ? 1 : found->second;
}

void NamedImportance::set(const std::string& name, double factor) {
  const auto place = std::ranges::lower_bound(
      factors, name, {}, [](const auto& one) -> const std::string& { return one.first; });
  if (place != factors.end() && place->first == name)
    place->second = factor;
  else
    factors.insert(place, {name, factor});
}

bool is_body_part(std::string_view name) {
  return std::ranges::any_of(kBodyParts,
                             [&](BodyPart part) { return mocapress::name(part) == name; });
}

std::vector<int> joints_named(const Skeleton& skeleton, const std::string& name) {
  for (const BodyPart part : kBodyParts)
    if (name == mocapress::name(part)) return joints_of(skeleton, part);
  const int joint = skeleton.find(name);
  return joint < 0 ? std::vector<int>{} : std::vector{joint};
}

Importance importance_for(const NamedImportance& named, const Skeleton& skeleton) {
  Importance importance{.joints = {}, .contacts = named.contacts};
  std::vector<double> factors(skeleton.joint_count(), 1.0);
  for (const bool parts : {true, false})
    for (const auto& [name, factor] : named.factors) {
      if (is_body_part(name) != parts) continue;
      const std::vector<int> joints = joints_named(skeleton, name);
      if (joints.empty() && !parts) throw Error("the skeleton has no joint named " + name);
      for (const int joint : joints) factors[joint] = factor;
    }
  const bool even = std::ranges::all_of(factors, [](double factor) { return factor == 1; });
  if (!even) importance.joints = std::move(factors);
  return importance;
}

NamedImportance named(const Importance& importance, const Skeleton& skeleton) {
  NamedImportance named{.factors = {}, .contacts = importance.contacts};
  if (importance.joints.empty()) return named;
  std::vector<double> covered(importance.joints.size(), 1.0);
  for (const BodyPart part : kBodyParts) {
    const std::vector<int> joints = joints_of(skeleton, part);
    if (joints.empty()) continue;
    // A joint that is named like its part cannot be listed by name, so the part gets its factor.
    const int namesake = skeleton.find(std::string(name(part)));
    const bool has_namesake = std::ranges::find(joints, namesake) != joints.end();
    const double factor =
        has_namesake ? importance.joints[namesake] : usual_factor(importance.joints, joints);
    if (factor == 1) continue;
    named.set(std::string(name(part)), factor);
    for (const int joint : joints) covered[joint] = factor;
  }
  for (std::size_t j = 0; j < covered.size(); ++j)
    if (importance.joints[j] != covered[j])
      named.set(skeleton.joint(static_cast<int>(j)).name, importance.joints[j]);
  return named;
}

}  // namespace mocapress
