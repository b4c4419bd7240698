// SPDX-License-Identifier: MIT
#include "core/codec/encode/slope.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/metrics/rate.h"
#include "core/motion/body_part.h"

namespace mocapress {
namespace {

constexpr double kNothing = 1.01;  // a smaller gain is not worth another encode

/// All joints except the given ones.
std::vector<int> rest_of(const Skeleton& skeleton, const std::vector<int>& joints) {
  std::vector<int> rest;
  for (int j = 0; j < skeleton.joint_count(); ++j)
    if (std::ranges::find(joints, j) == joints.end()) rest.push_back(j);
  return rest;
}

/// Raises the bounds of promises about body parts that have any of the joints.
void raise_promises(const Skeleton& skeleton, const std::vector<int>& joints, double times,
                    Promises& promises) {
  constexpr std::pair<BodyPart, std::optional<double> Promises::*> kOfParts[] = {
      {BodyPart::Head, &Promises::head_degrees},
      {BodyPart::Hands, &Promises::hand_degrees},
      {BodyPart::Fingers, &Promises::finger_degrees}};
  for (const auto& [part, promise] : kOfParts) {
    const std::vector<int> of_part = joints_of(skeleton, part);
    const bool concerned = std::ranges::any_of(
        of_part, [&](int joint) { return std::ranges::find(joints, joint) != joints.end(); });
    if (concerned && promises.*promise) *(promises.*promise) *= times;
  }
}

/// A target that the encoding just meets, of the wanted kind or, where that cannot be, a similar
/// one.
Target target_met(Target::Kind kind, const Clip& clip, const Standing& standing) {
  switch (kind) {
    case Target::Kind::Ratio:
    case Target::Kind::CoefficientRatio:
      return {Target::Kind::Ratio,
              compression_ratio(clip, static_cast<std::size_t>(standing.bytes))};
    case Target::Kind::Size:
      return {Target::Kind::Size, standing.bytes};
    default:
      return {Target::Kind::Error, standing.eps_cm};
  }
}

Standing encoded(const Encoder& encoder, const EncodeSettings& settings,
                 const Observer<EncodeProgress>& observer) {
  const Encoding encoding = encoder.encode(settings, observer);
  return standing_of(encoder.motion().skeleton, encoding.distortion, settings.weighting,
                     encoding.compressed.motion_bytes());
}

}  // namespace

double Standing::cm_of(const std::vector<int>& joints) const {
  if (joints.empty()) return 0;
  double squares = 0;
  for (const int joint : joints) squares += joints_cm(joint) * joints_cm(joint);
  return std::sqrt(squares / static_cast<double>(joints.size()));
}

Standing standing_of(const Skeleton& skeleton, const Distortion& distortion, Weighting weighting,
                     std::size_t motion_bytes) {
  Standing standing{static_cast<double>(motion_bytes), distortion.eps(weighting),
                    Eigen::ArrayXd::Zero(skeleton.joint_count())};
  const std::vector<Landmark> points = landmarks(skeleton);
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(skeleton.joint_count());
  for (std::size_t p = 0; p < points.size(); ++p) {
    const auto column = distortion.distances.col(p).cast<double>();
    standing.joints_cm(points[p].joint) += column.squaredNorm();
    counts(points[p].joint) += static_cast<double>(column.size());
  }
  standing.joints_cm = (standing.joints_cm / counts.max(1)).sqrt();
  return standing;
}

Slope relax(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
            const std::vector<int>& joints, double times,
            const Observer<EncodeProgress>& observer) {
  const Skeleton& skeleton = encoder.motion().skeleton;
  Slope slope{settings, {}};
  slope.settings.figures_only = slope.settings.size_will_do = false;
  std::vector<double>& weights = slope.settings.importance.joints;
  weights.resize(skeleton.joint_count(), 1);
  for (const int joint : joints) weights[joint] /= times * times;
  raise_promises(skeleton, joints, times, slope.settings.promises);

  // The first encode keeps eps_x, so the other joints gain what these lose. The second raises the
  // target by that gain, so that the others stay as they were.
  slope.settings.target = {Target::Kind::Error, now.eps_cm};
  const std::vector<int> others = rest_of(skeleton, joints);
  slope.standing = encoded(encoder, slope.settings, observer);
  const double nearer = slope.standing.cm_of(others);
  const double gained = nearer > 0 ? std::clamp(now.cm_of(others) / nearer, 1.0, times) : 1;
  if (gained > kNothing) {
    slope.settings.target.value *= gained;
    slope.standing = encoded(encoder, slope.settings, observer);
  }
  slope.settings.target =
      settings.target.kind == Target::Kind::Error
          ? slope.settings.target
          : target_met(settings.target.kind, encoder.motion().clip, slope.standing);
  return slope;
}

Slope resize(const Encoder& encoder, const EncodeSettings& settings, const Standing& now,
             double times, const Observer<EncodeProgress>& observer) {
  Slope slope{settings, {}};
  slope.settings.figures_only = slope.settings.size_will_do = false;
  slope.settings.target = {Target::Kind::Size, std::floor(now.bytes * times)};
  slope.standing = encoded(encoder, slope.settings, observer);
  slope.settings.target = target_met(settings.target.kind, encoder.motion().clip, slope.standing);
  return slope;
}

}  // namespace mocapress
