// SPDX-License-Identifier: MIT
#include "core/formats/bvh_conventions.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/motion/body_part.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"

namespace mocapress {
namespace {

constexpr double kClear = 0.25;  // share of OFFSET: a mean this near to zero or to OFFSET is clear

/// A translation channel along an axis in which the joint's offset is not zero.
struct OffsetColumn {
  Eigen::Index column;
  int axis;
  double offset;
};

std::vector<OffsetColumn> offset_columns(const Skeleton& skeleton, int index) {
  const Joint& joint = skeleton.joint(index);
  std::vector<OffsetColumn> columns;
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const int axis = axis_of(joint.channels[i]);
    if (!is_rotation(joint.channels[i]) && joint.offset(axis) != 0)
      columns.push_back(
          {skeleton.first_channel(index) + static_cast<Eigen::Index>(i), axis, joint.offset(axis)});
  }
  return columns;
}

/// The position of the mean translation along the offset: 0 at zero, 1 at the offset's end.
double share_of_offset(const Clip& clip, const std::vector<OffsetColumn>& columns) {
  double along = 0;
  double squared_length = 0;
  for (const OffsetColumn& column : columns) {
    along += clip.channels.col(column.column).mean() * column.offset;
    squared_length += column.offset * column.offset;
  }
  return along / squared_length;
}

bool begins_at_offset(const Clip& clip, const std::vector<OffsetColumn>& columns) {
  constexpr double kRounding = 1e-4;  // share of the offset: files have few decimals
  return std::ranges::all_of(columns, [&](const OffsetColumn& column) {
    return std::abs(clip.channels(0, column.column) - column.offset) <=
           kRounding * std::abs(column.offset);
  });
}

/// The column of the up axis alone if most of the offset lies along it, else all columns.
std::vector<OffsetColumn> steady_columns(const std::vector<OffsetColumn>& columns, UpAxis up) {
  const int up_axis = up == UpAxis::Y ? 1 : 2;
  double squared_length = 0;
  for (const OffsetColumn& column : columns) squared_length += column.offset * column.offset;
  for (const OffsetColumn& column : columns)
    if (column.axis == up_axis && 2 * column.offset * column.offset > squared_length)
      return {column};
  return columns;
}

TranslationGuess guess_root(const Clip& clip, const std::vector<OffsetColumn>& columns, UpAxis up,
                            const std::optional<TranslationGuess>& others) {
  if (begins_at_offset(clip, columns)) return {TranslationConvention::Replaces, true};
  if (others && others->clear) return *others;
  const double share = share_of_offset(clip, steady_columns(columns, up));
  if (std::abs(share) <= kClear) return {TranslationConvention::Adds, true};
  return {TranslationConvention::Replaces, std::abs(share - 1) <= kClear};
}

std::optional<TranslationGuess> guess_others(const Motion& motion) {
  int all = 0;
  int replaces = 0;
  int unclear = 0;
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
    if (motion.skeleton.joint(j).parent < 0) continue;
    const auto columns = offset_columns(motion.skeleton, j);
    if (columns.empty()) continue;
    const double share = share_of_offset(motion.clip, columns);
    ++all;
    replaces += share > 0.5;
    unclear += share > kClear && share < 1 - kClear;
  }
  if (all == 0) return std::nullopt;
  const bool clear = 2 * unclear <= all;
  const bool adds = clear && 2 * replaces <= all;
  return TranslationGuess{adds ? TranslationConvention::Adds : TranslationConvention::Replaces,
                          clear};
}

}  // namespace

TranslationGuesses guess_translation(const Motion& motion, UpAxis up) {
  TranslationGuesses guesses{{}, guess_others(motion)};
  for (int j = 0; j < motion.skeleton.joint_count(); ++j) {
    if (motion.skeleton.joint(j).parent >= 0) continue;
    const auto columns = offset_columns(motion.skeleton, j);
    if (columns.empty()) continue;
    guesses.roots = guess_root(motion.clip, columns, up, guesses.others);
    break;  // other roots are assumed to do the same
  }
  return guesses;
}

void subtract_offsets(const Skeleton& skeleton, bool of_roots, Clip& clip) {
  for (int c = 0; c < skeleton.channel_count(); ++c) {
    const ChannelKind kind = skeleton.channel_kind(c);
    const Joint& joint = skeleton.joint(skeleton.channel_joint(c));
    if (!is_rotation(kind) && (joint.parent < 0) == of_roots)
      clip.channels.col(c).array() -= joint.offset(axis_of(kind));
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

bool stands_along_z(const Motion& motion) {
  const std::vector<int> heads = namesakes_of(motion.skeleton, BodyPart::Head);
  const std::vector<int> feet = joints_of(motion.skeleton, BodyPart::Feet);
  if (heads.empty() || feet.empty()) return false;
  const auto mean = [](const std::vector<int>& joints, const Pose& pose) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int joint : joints) sum += pose.origin[joint];
    return Eigen::Vector3d(sum / static_cast<double>(joints.size()));
  };
  const auto stands = [&](const Eigen::Vector3d& feet_to_head) {
    constexpr double kUpright = 0.85;  // cosine of about 30 degrees
    return feet_to_head.z() > kUpright * feet_to_head.norm();
  };
  Pose pose = rest_pose(motion.skeleton);
  if (!stands(mean(heads, pose) - mean(feet, pose))) return false;
  constexpr int kLooks = 32;
  const int frames = motion.clip.frames();
  const int step = std::max(1, frames / kLooks);
  Eigen::Vector3d over_time = Eigen::Vector3d::Zero();
  for (int frame = 0; frame < frames; frame += step) {
    compute_pose(motion.skeleton, motion.clip.channels.row(frame), pose);
    over_time += mean(heads, pose) - mean(feet, pose);
  }
  return stands(over_time);
}

double guess_cm_per_unit(double height) {
  struct Unit {
    double cm;
    double shortest, tallest;  // range of heights in cm, between the ends of the bones
  };
  constexpr Unit kUnits[] = {{100, 120, 220},  {10, 150, 180}, {2.54 / 0.45, 130, 200},
                             {2.54, 150, 185}, {1, 100, 260},  {0.1, 120, 220}};
  if (height <= 0) return 1;
  const Unit* larger = nullptr;
  for (const Unit& unit : kUnits) {
    const double first = unit.shortest / unit.cm;
    if (height < first && larger == nullptr) return unit.shortest / height;
    if (height < first) {
      const double last = larger->tallest / larger->cm;
      const double share = std::log(height / last) / std::log(first / last);
      return larger->cm * std::pow(unit.cm / larger->cm, share);
    }
    if (height <= unit.tallest / unit.cm) return unit.cm;
    larger = &unit;
  }
  return larger->tallest / height;
}

std::optional<double> rate_from_frame_time(double frame_time) {
  if (!(frame_time >= 1e-4 && frame_time <= 1e4)) return std::nullopt;
  const double rate = frame_time > 1 ? frame_time : 1 / frame_time;
  const double whole = std::round(rate);
  return std::abs(rate - whole) < 1e-4 * whole ? whole : rate;
}

}  // namespace mocapress
