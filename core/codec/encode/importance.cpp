// SPDX-License-Identifier: MIT
#include "core/codec/encode/importance.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/error.h"

namespace mocapress {

MeasuredPoints important_points(const Skeleton& skeleton, Weighting weighting,
                                const Importance& importance) {
  MeasuredPoints measured = measured_points(skeleton, weighting);
  if (importance.joints.empty()) return measured;
  if (std::ssize(importance.joints) != skeleton.joint_count())
    throw Error("the importance of every joint is needed, or of none");
  for (const double factor : importance.joints)
    if (!std::isfinite(factor) || factor < 0)
      throw Error("the importance of a joint must be a number, 0 or more");
  Eigen::VectorXd& weights = measured.weights;
  for (Eigen::Index p = 0; p < weights.size(); ++p) {
    const auto joint = measured.points[static_cast<std::size_t>(p)].joint;
    weights(p) *= importance.joints[static_cast<std::size_t>(joint)];
  }
  if (weights.sum() <= 0) throw Error("no joint is of any importance");
  weights /= weights.sum();
  return measured;
}

std::vector<PointResponse> standing_points(const Skeleton& skeleton,
                                           const Eigen::MatrixXd& original_tracks,
                                           const std::vector<ContactSpan>& contacts,
                                           double importance) {
  // Of joints, so that feet whose joint carries no weight of its own count too.
  const double share = 1.0 / std::max(skeleton.joint_count(), 1);
  std::map<int, PointResponse> points;
  for (const ContactSpan& span : contacts) {
    if (span.landmark >= skeleton.joint_count()) continue;  // the end of a bone
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

}  // namespace mocapress
