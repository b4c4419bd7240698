// SPDX-License-Identifier: MIT
#include "core/codec/encode/analysis/form_choice.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/codec/format/adaptive.h"
#include "core/codec/format/axes_section.h"
#include "core/motion/forward_kinematics.h"
#include "core/motion/landmarks.h"
#include "core/wavelet/lifting.h"

namespace mocapress {
namespace {

// A rotation order that takes the fewest bits at one error does so at others too, so one choice
// serves all targets.
constexpr double kScale = 1.8;     // cm; quantisation scale, as for an eps_x of 0.5 cm
constexpr double kRate = 30;       // Hz; higher rates hardly change the choice
constexpr double kLongRate = 15;   // Hz; for clips too long for kRate
constexpr int kEnough = 256;       // frames; longer clips are sampled more coarsely
constexpr int kMostFrames = 2048;  // frames looked at together
constexpr double kWorthIt =
    0.98;  // share of the bits; a change must save 2 % to replace the skeleton's own form
constexpr double kTurnedBits = 40;  // bits, as counted here, that turned axes cost in the file

/// Returns whether a joint may get another rotation form. It may not if one of its angles is
/// constant, since the angle would move in another form.
bool may_choose(const Skeleton& skeleton, const std::vector<bool>& still, int j) {
  if (!turns_freely(skeleton.joint(j))) return false;
  const int first = skeleton.first_channel(j);
  const auto channels = static_cast<int>(skeleton.joint(j).channels.size());
  for (int c = first; c < first + channels; ++c)
    if (is_rotation(skeleton.channel_kind(c)) && still[c]) return false;
  return true;
}

/// Orders about turned axes, with the twist innermost.
constexpr std::array<RotationOrder, 2> kTurnedOrders = {RotationOrder::Yzx, RotationOrder::Zyx};
constexpr std::size_t kCandidates = kRotationOrders + kTurnedOrders.size();

/// Bits for each candidate: all orders, then the orders about turned axes.
using Bits = std::array<double, kCandidates>;

/// Reverses some of the axes, so that they are right-handed and as near to the identity as
/// possible.
Eigen::Matrix3d nearest_frame(Eigen::Matrix3d axes) {
  if (axes.determinant() < 0) axes = -axes;
  Eigen::Matrix3d best = axes;
  for (int kept = 0; kept < 3; ++kept) {
    Eigen::Matrix3d other = -axes;
    other.col(kept) = axes.col(kept);
    if (other.trace() > best.trace()) best = other;
  }
  return best;
}

/// The measured points that a joint carries, as sums over their places x and weights w: of w, w x
/// and w x x^T.
struct Burden {
  double mass = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d square = Eigen::Matrix3d::Zero();

  void add(double weight, const Eigen::Vector3d& place) {
    mass += weight;
    moment += weight * place;
    square += weight * place * place.transpose();
  }
  void add(const Burden& other) {
    mass += other.mass;
    moment += other.moment;
    square += other.square;
  }

  /// Returns the inertia I about `origin`: after a turn by a small angle a about an axis through
  /// `origin`, the weighted sum of the points' squared movements is a^2 axis^T I axis.
  Eigen::Matrix3d inertia_about(const Eigen::Vector3d& origin) const {
    const Eigen::Matrix3d seen = square - moment * origin.transpose() -
                                 origin * moment.transpose() + mass * origin * origin.transpose();
    return seen.trace() * Eigen::Matrix3d::Identity() - seen;
  }
};

/// The rotations of joints over some frames, and the inertia of the points that they carry.
class Turns {
 public:
  /// Takes every `step`-th frame from `first` on: kMostFrames of them, or up to the clip's end.
  Turns(const Motion& motion, const MeasuredPoints& measured, int first, int step)
      : step_(step),
        frames_(std::min(kMostFrames, (motion.clip.frames() - first + step - 1) / step)),
        joints_(static_cast<std::size_t>(motion.skeleton.joint_count())) {
    for (OfJoint& joint : joints_) {
      joint.rotations.resize(frames_);
      joint.inertias.resize(frames_);
    }
    parallel_ranges(0, frames_, 64, [&](int from, int end) {
      Pose pose;
      std::vector<Burden> burdens;
      for (int t = from; t < end; ++t) {
        compute_pose(motion.skeleton, motion.clip.channels.row(first + t * step), pose);
        burdens.assign(joints_.size(), {});
        for (std::size_t p = 0; p < measured.points.size(); ++p) {
          const Landmark& point = measured.points[p];
          burdens[point.joint].add(measured.weights(p),
                                   pose.to_world(point.joint, point.in_joint) - pose.origin[0]);
        }
        for (std::size_t j = joints_.size(); j-- > 0;) {
          const Joint& joint = motion.skeleton.joints()[j];
          const auto parent = static_cast<std::size_t>(joint.parent);
          if (joint.parent >= 0) burdens[parent].add(burdens[j]);
          if (!turns_freely(joint)) continue;
          const Eigen::Matrix3d axes_from_world =
              (joint.parent < 0 ? joint.joint_from_axes
                                : pose.world_from_joint[parent] * joint.joint_from_axes)
                  .transpose();
          const auto i = static_cast<std::size_t>(t);
          joints_[j].rotations[i] =
              axes_from_world * pose.world_from_joint[j] * joint.joint_from_axes;
          joints_[j].inertias[i] = axes_from_world *
                                   burdens[j].inertia_about(pose.origin[j] - pose.origin[0]) *
                                   axes_from_world.transpose();
        }
      }
    });
  }

  int frames() const { return frames_; }

  /// Returns a form about the principal axes of what the joint carries: along and across the limb.
  RotationForm along_limb(int j) const {
    const OfJoint& joint = joints_[j];
    Eigen::Matrix3d rotations = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < joint.rotations.size(); ++i) {
      rotations += joint.rotations[i];
      inertia += joint.inertias[i];
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(rotations,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d mean = svd.matrixU() * svd.matrixV().transpose();
    if (mean.determinant() < 0) mean -= 2 * svd.matrixU().col(2) * svd.matrixV().col(2).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(inertia);
    RotationForm form;
    form.before = fixed_turn_near(nearest_frame(principal.eigenvectors()));
    form.after = fixed_turn_near(rotation_of(form.before).transpose() * mean);
    return form;
  }

  /// Estimates the bits of a joint's detail coefficients. An angle's quantisation step is inversely
  /// proportional to how far the angle moves the body.
  double bits(int j, const RotationForm& form) const {
    const OfJoint& joint = joints_[j];
    const std::array<int, 3> axes = axes_of(form.order);
    const Eigen::Matrix3d before = rotation_of(form.before);
    const Eigen::Matrix3d left = before.transpose();
    const double sign = (axes[0] + 1) % 3 == axes[1] ? 1 : -1;  // sign of the axes' permutation
    const Eigen::Matrix3d right = rotation_of(form.after).transpose();
    Eigen::MatrixXd angles(frames_, 3);
    Eigen::Vector3d curvature = Eigen::Vector3d::Zero();
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    for (int t = 0; t < frames_; ++t) {
      const auto i = static_cast<std::size_t>(t);
      const Eigen::Matrix3d rotation = form.has_fixed_turns()
                                           ? Eigen::Matrix3d(left * joint.rotations[i] * right)
                                           : joint.rotations[i];
      last = three_angles(axes, rotation, last);
      angles.row(t) = last.transpose();
      // The first angle turns the second axis. The third axis stays in place while its own angle
      // turns, so it is a column of the whole rotation.
      const std::array<Eigen::Vector3d, 3> turned = {
          before.col(axes[0]),
          before.col(axes[1]) * std::cos(last(0)) +
              before.col(axes[2]) * (sign * std::sin(last(0))),
          before * rotation.col(axes[2])};
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d& axis = turned[k];
        curvature(k) += axis.dot(joint.inertias[i] * axis) / frames_;
      }
    }
    const Lifting lifting(Basis::Cubic, frames_);
    const std::vector<double> gains = lifting.gains();
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const std::span<double> signal(angles.col(k).data(), static_cast<std::size_t>(frames_));
      lifting.forward(signal, signal);
      // If no frames were skipped, coefficients would be larger by the square root of `step_`.
      const double steps_per_unit = std::sqrt(curvature(k) * step_) / kScale;
      double product = 1;  // several factors share one logarithm, which is slow
      for (int c = lifting.bands()[0].size; c < frames_; ++c) {
        const double steps = angles(c, k) * gains[c] * steps_per_unit;
        product *= 1 + steps * steps;
        if (product < 1e100) continue;
        sum += std::log2(product);
        product = 1;
      }
      sum += std::log2(product);
    }
    return sum;
  }

 private:
  struct OfJoint {
    std::vector<Eigen::Matrix3d> rotations;  // about its own axes
    std::vector<Eigen::Matrix3d>
        inertias;  // of what the joint carries, in the joint's axes at zero rotation
  };

  int step_;
  int frames_;
  std::vector<OfJoint> joints_;
};

/// For each joint, the bits of its candidate forms, and the form with turned axes.
struct Count {
  std::vector<Bits> bits;
  RotationForms turned;
};

Count count_bits(const Motion& motion, const std::vector<bool>& still) {
  const MeasuredPoints measured = measured_points(motion.skeleton, Weighting::Surface);
  const auto step_at = [&](double rate) {
    return std::max(1, static_cast<int>(std::lround(motion.clip.sample_rate_hz / rate)));
  };
  const int step = std::clamp(motion.clip.frames() / kEnough, step_at(kRate), step_at(kLongRate));
  const auto joints = static_cast<std::size_t>(motion.skeleton.joint_count());
  Count count{std::vector<Bits>(joints, Bits{}), RotationForms(joints)};
  // In a long clip the first part decides the axes.
  for (int first = 0; first < motion.clip.frames(); first += step * kMostFrames) {
    const Turns turns(motion, measured, first, step);
    parallel_for(0, motion.skeleton.joint_count(), [&](int j) {
      const Joint& joint = motion.skeleton.joint(j);
      if (!may_choose(motion.skeleton, still, j)) return;
      Bits& bits = count.bits[j];
      for (std::size_t o = 0; o < kRotationOrders; ++o)
        bits[o] += turns.bits(j, {static_cast<RotationOrder>(o)});
      if (!may_turn_axes(joint)) return;
      RotationForm& turned = count.turned[j];
      if (first == 0) turned = turns.along_limb(j);
      for (std::size_t o = 0; o < kTurnedOrders.size(); ++o) {
        turned.order = kTurnedOrders[o];
        bits[kRotationOrders + o] += turns.bits(j, turned);
      }
    });
  }
  return count;
}

/// For each joint, the joint whose angles predict its own, or -1.
std::vector<int> mirrors_of(const Skeleton& skeleton) {
  const std::vector<SignalNeighbours> neighbours = channel_neighbours(skeleton);
  std::vector<int> mirrors(skeleton.joint_count(), -1);
  for (int j = 0; j < skeleton.joint_count(); ++j) {
    if (skeleton.joint(j).channels.empty()) continue;
    const int mirror = neighbours[skeleton.first_channel(j)].mirror;
    if (mirror >= 0) mirrors[j] = skeleton.channel_joint(mirror);
  }
  return mirrors;
}

}  // namespace

RotationForms choose_forms(const Motion& motion) {
  const Skeleton& skeleton = motion.skeleton;
  const std::vector<bool> still = still_channels(motion.clip);
  auto [bits, turned] = count_bits(motion, still);
  const std::vector<int> mirrors = mirrors_of(skeleton);
  RotationForms forms = rotation_forms(skeleton);
  for (std::size_t j = 0; j < forms.size(); ++j)
    for (std::size_t o = kRotationOrders; o < kCandidates; ++o)
      bits[j][o] = may_turn_axes(skeleton.joints()[j]) && turned[j].has_fixed_turns()
                       ? bits[j][o] + kTurnedBits
                       : std::numeric_limits<double>::infinity();
  // The first of several joints that mirror one another chooses the form for all of them.
  const auto follows = [&](std::size_t j) {
    return mirrors[j] >= 0 && may_choose(skeleton, still, mirrors[j]);
  };
  for (std::size_t j = forms.size(); j-- > 0;)
    if (follows(j))
      for (std::size_t o = 0; o < kCandidates; ++o) bits[mirrors[j]][o] += bits[j][o];
  for (std::size_t j = 0; j < forms.size(); ++j) {
    if (!may_choose(skeleton, still, static_cast<int>(j))) continue;
    if (follows(j)) {
      const RotationForm& leader = forms[mirrors[j]];
      if (leader.has_fixed_turns()) forms[j] = turned[j];
      forms[j].order = leader.order;
      continue;
    }
    const auto best = std::ranges::min_element(bits[j]);
    if (*best >= kWorthIt * bits[j][static_cast<std::size_t>(forms[j].order)]) continue;
    const auto found = static_cast<std::size_t>(best - bits[j].begin());
    if (found >= kRotationOrders) forms[j] = turned[j];
    forms[j].order = found < kRotationOrders ? static_cast<RotationOrder>(found)
                                             : kTurnedOrders[found - kRotationOrders];
  }
  return forms;
}

}  // namespace mocapress
