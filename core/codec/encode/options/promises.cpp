// SPDX-License-Identifier: MIT
#include "core/codec/encode/options/promises.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "core/base/number_text.h"
#include "core/codec/encode/options/importance.h"
#include "core/motion/body_part.h"
#include "core/motion/landmarks.h"

namespace mocapress {

namespace {

/// Returns whether the root stays at the height of the lowest joint, as in game rigs.
bool root_is_on_floor(const Motion& motion) {
  constexpr int kMostFrames = 256;
  constexpr double kNear = 5;  // cm
  const int step = motion.clip.frames() / kMostFrames + 1;
  const auto frames = Eigen::seq(0, motion.clip.frames() - 1, step);
  const Eigen::MatrixXd tracks = landmark_tracks(
      motion.skeleton, {motion.clip.sample_rate_hz, motion.clip.channels(frames, Eigen::all)});
  double floor = std::numeric_limits<double>::infinity();
  for (Eigen::Index y = 4; y < tracks.cols(); y += 3)
    floor = std::min(floor, tracks.col(y).minCoeff());
  return tracks.cols() > 3 && (tracks.col(1).array() - floor).abs().maxCoeff() < kNear;
}

}  // namespace

std::vector<BrokenPromise> broken_promises(const Promises& promises, const Motion& original,
                                           const Distortion& distortion) {
  const Skeleton& skeleton = original.skeleton;
  std::vector<BrokenPromise> broken;
  const auto look_at = [&](int joint, std::string_view what, double found,
                           const std::optional<double>& promised, bool root) {
    if (!promised || found <= *promised) return;
    broken.push_back({skeleton.joint(joint).name + " is " + std::string(what) + " by " +
                          significant_text(found, 3) + ", not " + significant_text(*promised, 3),
                      joint, found / *promised, root});
  };
  const auto look_at_part = [&](BodyPart part, const std::optional<double>& promised) {
    for (const int joint : namesakes_of(skeleton, part))
      look_at(joint, "turned (degrees, RMS)", distortion.joint_degrees(joint), promised, false);
  };
  look_at_part(BodyPart::Head, promises.head_degrees);
  look_at_part(BodyPart::Hands, promises.hand_degrees);
  look_at_part(BodyPart::Fingers, promises.finger_degrees);
  const bool of_root = promises.root_cm || promises.root_degrees;
  if (!of_root || original.clip.frames() == 0 || !root_is_on_floor(original)) return broken;
  look_at(0, "off (cm)", distortion.joint_max_cm(0), promises.root_cm, true);
  look_at(0, "turned (degrees)", distortion.joint_max_degrees(0), promises.root_degrees, true);
  return broken;
}

void raise_importance(const std::vector<BrokenPromise>& broken, const Skeleton& skeleton,
                      Importance& importance) {
  constexpr double kMore =
      1.1;                      // margin on the factor from the model, which errs by a few per cent
  constexpr double kMost = 30;  // largest factor in one round
  constexpr double kFirst = 0.02;  // least weight of a raised root, as a share of the others'
  const auto raised = [&](double weight, double times) {
    return weight * std::min(kMore * times * times, kMost);
  };
  for (const BrokenPromise& promise : broken) {
    if (promise.root) {
      // The root's largest error falls faster than its mean.
      importance.root = std::max(kFirst, kMore * promise.times * importance.root);
      continue;
    }
    importance.joints.resize(skeleton.joint_count(), 1.0);
    double& factor = importance.joints[promise.joint];
    factor = raised(factor, promise.times);
  }
}

}  // namespace mocapress
