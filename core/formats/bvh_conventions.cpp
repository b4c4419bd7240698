// SPDX-License-Identifier: MIT
#include "core/formats/bvh_conventions.h"

#include <cmath>

#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

/// Where a joint's mean translation lies between zero (0) and its offset (1), looking only at the
/// components it has channels for. Nothing without an offset or a channel.
std::optional<double> share_of_offset(const Motion& motion, int index) {
  const Joint& joint = motion.skeleton.joint(index);
  double along = 0;
  double squared_length = 0;
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    if (is_rotation(joint.channels[i])) continue;
    const double offset = joint.offset(axis_of(joint.channels[i]));
    const auto column = motion.skeleton.first_channel(index) + static_cast<Eigen::Index>(i);
    along += motion.clip.channels.col(column).mean() * offset;
    squared_length += offset * offset;
  }
  if (squared_length <= 0) return std::nullopt;
  return along / squared_length;
}

struct Votes {
  int all = 0;
  int replaces = 0;
  int unclear = 0;

  void cast(double share) {
    ++all;
    replaces += share > 0.5;
    unclear += share > 0.25 && share < 0.75;
  }
};

}  // namespace

std::optional<TranslationGuess> guess_translation(const Motion& motion) {
  Votes roots;
  Votes others;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j)
    if (const auto share = share_of_offset(motion, j))
      (motion.skeleton.joint(j).parent < 0 ? roots : others).cast(*share);
  const Votes& votes = others.all > 0 ? others : roots;
  if (votes.all == 0) return std::nullopt;
  return TranslationGuess{2 * votes.replaces > votes.all ? TranslationConvention::Replaces
                                                         : TranslationConvention::Adds,
                          2 * votes.unclear <= votes.all};
}

void subtract_offsets(const Skeleton& skeleton, Clip& clip) {
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const ChannelKind kind = skeleton.channel_kind(c);
    if (!is_rotation(kind))
      clip.channels.col(c).array() -=
          skeleton.joint(skeleton.channel_joint(c)).offset(axis_of(kind));
  }
}

double rest_height(const Skeleton& skeleton) {
  const Pose pose = rest_pose(skeleton);
  Eigen::Vector3d low = Eigen::Vector3d::Constant(HUGE_VAL);
  Eigen::Vector3d high = -low;
  for (const Landmark& landmark : landmarks(skeleton)) {
    const Eigen::Vector3d point = pose.to_world(landmark.joint, landmark.in_joint);
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return (high - low).maxCoeff();
}

double guess_cm_per_unit(double height) {
  constexpr double kUsual = 170;  // cm
  if (height <= 0 || (height >= 80 && height <= 260)) return 1;
  double best = 1;
  for (const double cm : {100.0, 0.1, 2.54, 2.54 / 0.45, 10.0})
    if (std::abs(std::log(height * cm / kUsual)) < std::abs(std::log(height * best / kUsual)))
      best = cm;
  return best;
}

std::optional<double> rate_from_frame_time(double frame_time) {
  if (!(frame_time >= 1e-4 && frame_time <= 1e4)) return std::nullopt;
  const double rate = frame_time > 1 ? frame_time : 1 / frame_time;
  const double whole = std::round(rate);
  return std::abs(rate - whole) < 1e-4 * whole ? whole : rate;
}

}  // namespace mocapress
