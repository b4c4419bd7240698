// SPDX-License-Identifier: MIT
#include "core/mocapress/python/bindings/local_transforms.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/base/parallel.h"
#include "core/motion/forward_kinematics.h"
#include "core/runtime/format/format_limits.h"
#include "core/runtime/format/kinematics.h"

namespace mocapress::python {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::array<int, 3> kOrder = {2, 0, 1};  // Z X Y

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why);
}

/// Calls visit(joint, frame, rotation, translation) with what the joint's channels alone determine,
/// without its offset and axes.
template <typename Visit>
void visit_channels(const Motion& motion, const Visit& visit) {
  const Eigen::MatrixXd& channels = motion.clip.channels;
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    const int first = motion.skeleton.first_channel(j);
    for (Eigen::Index f = 0; f < channels.rows(); ++f) {
      Matrix3d rotation = Matrix3d::Identity();
      Vector3d translation = Vector3d::Zero();
      runtime::apply_channels(
          joint.channels.data(), static_cast<int>(joint.channels.size()),
          [&](int c) { return channels(f, first + c); }, rotation, translation);
      visit(j, f, rotation, translation);
    }
  });
}

void check(const LocalTransforms& given) {
  const auto joints = static_cast<Eigen::Index>(given.names.size());
  if (joints == 0) refuse("a motion has at least one joint");
  if (joints > runtime::kMostJoints)
    refuse("more than " + std::to_string(runtime::kMostJoints) + " joints");
  if (std::ssize(given.parents) != joints)
    refuse("parents are not one for each of " + std::to_string(joints) + " names");
  for (Eigen::Index j = 0; j < joints; ++j)
    if (const int parent = given.parents[j]; parent < -1 || parent >= j)
      refuse("the parent of joint " + std::to_string(j) + " does not come before it");
  if (given.offsets.rows() != joints || given.offsets.cols() != 3)
    refuse("offsets are not joints x 3");
  if (given.rotations.cols() != 4 * joints || given.rotations.rows() == 0)
    refuse("rotations are not frames x joints x 4");
  if (given.translations.cols() > 0 && given.translations.rows() != given.rotations.rows())
    refuse("translations have another number of frames than rotations");
  for (const auto& [joint, site] : given.end_sites)
    if (joint < 0 || joint >= joints || !site.allFinite())
      refuse("an end site is not of a joint, or not finite");
  if (!std::isfinite(given.sample_rate_hz) || given.sample_rate_hz <= 0)
    refuse("the rate is not above 0");
  if (!given.offsets.allFinite() || !given.rotations.allFinite() || !given.translations.allFinite())
    refuse("a value is not finite");
}

/// The given translations of one joint, frames x 3; no rows if none were given.
Eigen::MatrixX3d translations_of(const LocalTransforms& given, Eigen::Index joint) {
  const Eigen::Index first = 3 * joint;
  if (given.translations.cols() < first + 3) return {};
  return given.translations.middleCols(first, 3);
}

bool stays(const Eigen::MatrixX3d& places) {
  constexpr double kSamePlace = 1e-4;  // cm: rounding error of floats some metres from the origin
  return places.rows() == 0 ||
         (places.rowwise() - places.row(0)).cwiseAbs().maxCoeff() <= kSamePlace;
}

Joint joint_of(const LocalTransforms& given, Eigen::Index j) {
  Joint joint{.name = given.names[j],
              .parent = given.parents[j],
              .offset = given.offsets.row(j).transpose()};
  if (const auto site = given.end_sites.find(static_cast<int>(j)); site != given.end_sites.end())
    joint.end_site = site->second;
  const Eigen::MatrixX3d places = translations_of(given, j);
  if (j > 0 && stays(places)) {
    if (places.rows() > 0) joint.offset = places.row(0).transpose();
  } else {
    for (int axis = 0; axis < 3; ++axis) joint.channels.push_back(translation_about(axis));
  }
  for (const int axis : kOrder) joint.channels.push_back(rotation_about(axis));
  return joint;
}

}  // namespace

Eigen::MatrixXd local_rotations(const Motion& motion) {
  const Eigen::Index frames = motion.clip.channels.rows();
  Eigen::MatrixXd rotations(frames, 4 * Eigen::Index{motion.skeleton.joint_count()});
  visit_channels(motion, [&](int j, Eigen::Index f, const Matrix3d& turned, const Vector3d&) {
    const JointAxes& axes = motion.skeleton.axes(j);
    const Matrix3d parent_from_joint = axes.parent_from_axes * turned * axes.axes_from_joint;
    const Quaterniond rotation = Quaterniond(parent_from_joint).normalized();
    Eigen::RowVector4d row(rotation.w(), rotation.x(), rotation.y(), rotation.z());
    const Eigen::Index column = 4 * Eigen::Index{j};
    if (f > 0 && rotations.block<1, 4>(f - 1, column).dot(row) < 0) row = -row;
    rotations.block<1, 4>(f, column) = row;
  });
  return rotations;
}

Eigen::MatrixXd local_translations(const Motion& motion) {
  const Eigen::Index frames = motion.clip.channels.rows();
  Eigen::MatrixXd translations(frames, 3 * Eigen::Index{motion.skeleton.joint_count()});
  visit_channels(motion, [&](int j, Eigen::Index f, const Matrix3d&, const Vector3d& moved) {
    translations.block<1, 3>(f, 3 * Eigen::Index{j}) =
        (motion.skeleton.joint(j).offset + moved).transpose();
  });
  return translations;
}

Motion motion_of(const LocalTransforms& given) {
  check(given);
  Motion motion;
  for (Eigen::Index j = 0; j < std::ssize(given.names); ++j)
    motion.skeleton.add(joint_of(given, j));
  motion.clip.sample_rate_hz = given.sample_rate_hz;
  const Eigen::Index frames = given.rotations.rows();
  motion.clip.channels.resize(frames, motion.skeleton.channel_count());
  parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
    const Joint& joint = motion.skeleton.joint(j);
    Eigen::Index column = motion.skeleton.first_channel(j);
    if (!is_rotation(joint.channels.front())) {
      const Eigen::MatrixX3d places = translations_of(given, j);
      auto moved = motion.clip.channels.middleCols(column, 3);
      if (places.rows() > 0)
        moved = places.rowwise() - joint.offset.transpose();
      else
        moved.setZero();
      column += 3;
    }
    Vector3d angles = Vector3d::Zero();
    for (Eigen::Index f = 0; f < frames; ++f) {
      const auto row = given.rotations.block<1, 4>(f, 4 * Eigen::Index{j});
      const Quaterniond rotation(row(0), row(1), row(2), row(3));
      if (rotation.norm() < 1e-6)
        refuse("rotations[" + std::to_string(f) + ", " + std::to_string(j) +
               "] is a quaternion of length 0");
      angles = three_angles(kOrder, rotation.normalized().toRotationMatrix(), angles);
      motion.clip.channels.block<1, 3>(f, column) = angles.transpose();
    }
  });
  return motion;
}

}  // namespace mocapress::python
