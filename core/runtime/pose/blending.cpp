// SPDX-License-Identifier: MIT
#include "core/runtime/pose/blending.h"

#include <algorithm>
#include <cstdlib>

namespace mocapress::runtime {
namespace {

// Weights outside of these bounds could make squares of sums overflow or underflow.
constexpr float kLightest = 1e-6F;
constexpr float kHeaviest = 1e6F;

float weight_of(const mcpr_weighted_pose& pose, std::uint32_t joint) {
  return pose.joint_weights == nullptr ? pose.weight : pose.weight * pose.joint_weights[joint];
}

/// True if the weight of every joint is within 0 ... `most`.
bool are_weights(const mcpr_weighted_pose& pose, std::uint32_t joints, float most) {
  if (!(pose.weight >= 0)) return false;
  bool all = true;
  for (std::uint32_t j = 0; j < (pose.joint_weights == nullptr ? 1 : joints); ++j) {
    const float weight = weight_of(pose, j);
    all = all && weight >= 0 && weight <= most;
  }
  return all;
}

template <typename Real>
Real weights_of(const mcpr_weighted_pose& pose, std::uint32_t joint) {
  const Real weight = all_joints<Real>(pose.weight);
  return pose.joint_weights == nullptr ? weight
                                       : weight * each_joint<Real>(pose.joint_weights + joint);
}

/// A weighted mean of transforms. Its code does not depend on the order of a quaternion's numbers.
template <typename Real>
class Mean {
 public:
  Mean(const Placed<Real>& first, Real weight)
      : turn_(weight * first.turn), shift_(weight * first.shift), total_(weight) {}

  void add(const Placed<Real>& placed, Real weight) {
    // The sign is chosen so that the sum does not get shorter. So it is never zero.
    turn_ = turn_ + negated_by(dot(turn_, placed.turn), weight) * placed.turn;
    shift_ = shift_ + weight * placed.shift;
    total_ = total_ + weight;
  }

  Placed<Real> value() const { return {normalised(turn_), all_joints<Real>(1) / total_ * shift_}; }

 private:
  Turn<Real> turn_;
  Shift<Real> shift_;
  Real total_;
};

/// Counts the poses that have a weight for a joint.
struct Counted {
  std::uint32_t count = 0;
  const mcpr_weighted_pose* last;  // the last of these poses; the first of all poses if there are
                                   // none

  Counted(const mcpr_weighted_pose* poses, std::uint32_t number, std::uint32_t joint)
      : last(poses) {
    for (std::uint32_t i = 0; i < number; ++i) {
      if (weight_of(poses[i], joint) < kLightest) continue;
      last = &poses[i];
      ++count;
    }
  }
};

/// Takes a joint's transforms from all poses that have a weight for it, and stores their mean.
void store_mean_of_some(const mcpr_weighted_pose* poses, std::uint32_t count, std::uint32_t joint,
                        mcpr_transform* out) {
  std::uint32_t i = 0;
  while (weight_of(poses[i], joint) < kLightest) ++i;
  Mean<float> mean(Placed<float>::load(poses[i].pose + joint), weight_of(poses[i], joint));
  for (++i; i < count; ++i)
    if (weight_of(poses[i], joint) >= kLightest)
      mean.add(Placed<float>::load(poses[i].pose + joint), weight_of(poses[i], joint));
  mean.value().store(out + joint);
}

/// Takes the joints' transforms from all poses, and stores their means.
template <typename Real>
void store_mean(const mcpr_weighted_pose* poses, std::uint32_t count, std::uint32_t joint,
                mcpr_transform* out) {
  Mean<Real> mean(Placed<Real>::load(poses[0].pose + joint), weights_of<Real>(poses[0], joint));
  for (std::uint32_t i = 1; i < count; ++i)
    mean.add(Placed<Real>::load(poses[i].pose + joint), weights_of<Real>(poses[i], joint));
  mean.value().store(out + joint);
}

/// Lays a pose over another, at joints whose weight is neither 0 nor 1.
template <typename Real>
void store_layered(const mcpr_weighted_pose& layer, std::uint32_t joint, mcpr_transform* pose) {
  const Real weight = weights_of<Real>(layer, joint);
  Mean<Real> mean(Placed<Real>::load(pose + joint), all_joints<Real>(1) - weight);
  mean.add(Placed<Real>::load(layer.pose + joint), weight);
  mean.value().store(pose + joint);
}

/// The mirror image of a transform, at the plane through the origin perpendicular to an axis.
template <typename Real>
Placed<Real> mirrored(const Placed<Real>& placed, int axis) {
  const Real minus = all_joints<Real>(-1);
  const auto& [q, t] = placed;
  return {{q.w, axis == 0 ? q.x : minus * q.x, axis == 1 ? q.y : minus * q.y,
           axis == 2 ? q.z : minus * q.z},
          {axis == 0 ? minus * t.x : t.x, axis == 1 ? minus * t.y : t.y,
           axis == 2 ? minus * t.z : t.z}};
}

Turn<float> constant_turn(const float (&wxyz)[4]) {
  return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

void keep_turn(const Turn<float>& turn, float (&wxyz)[4]) {
  wxyz[0] = turn.w;
  wxyz[1] = turn.x;
  wxyz[2] = turn.y;
  wxyz[3] = turn.z;
}

/// The rotation of a joint in the character's space.
Turn<float> turn_in_model(const PoseSpace& space, const mcpr_transform* pose,
                          const std::int16_t* parents, std::uint32_t joint) {
  Turn<float> turn = space.load<float>(pose + joint).turn;
  for (int j = parents[joint]; j >= 0; j = parents[j])
    turn = space.load<float>(pose + j).turn * turn;
  return normalised(turn);
}

}  // namespace

PoseSpace::PoseSpace(const mcpr_convention* convention) {
  if (convention == nullptr) return;
  w_last = convention->w_last != 0;
  constexpr int kClipsUp = 2;  // number of the y axis in mcpr_convention
  for (int i = 0; i < 3; ++i)
    if (std::abs(convention->axes[i]) == kClipsUp) up = i;
}

bool blend(const mcpr_weighted_pose* poses, std::uint32_t count, std::uint32_t joints,
           mcpr_transform* out) {
  bool has_mask = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!are_weights(poses[i], joints, kHeaviest)) return false;
    has_mask = has_mask || poses[i].joint_weights != nullptr;
  }
  if (joints == 0) return true;
  const Counted of_all(poses, count, 0);  // the result for every joint if no pose has a mask
  const auto counted = [&](std::uint32_t j) {
    return (has_mask ? Counted(poses, count, j) : of_all).count;
  };
  for_joints(joints, [&](auto real, std::uint32_t first) {
    using Real = decltype(real);
    bool all_count = count > 1;
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      all_count = all_count && counted(j) == count;
    if (all_count) return store_mean<Real>(poses, count, first, out);
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      if (counted(j) > 1)
        store_mean_of_some(poses, count, j, out);
      else
        out[j] = Counted(poses, count, j).last->pose[j];
  });
  return true;
}

bool blend_layer(const mcpr_weighted_pose& layer, std::uint32_t joints, mcpr_transform* pose) {
  if (!are_weights(layer, joints, 1)) return false;
  const auto mixed = [&](std::uint32_t j) {
    const float weight = weight_of(layer, j);
    return weight > 0 && weight < 1;
  };
  for_joints(joints, [&](auto real, std::uint32_t first) {
    using Real = decltype(real);
    bool all_mixed = true;
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      all_mixed = all_mixed && mixed(j);
    if (all_mixed) return store_layered<Real>(layer, first, pose);
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      if (mixed(j))
        store_layered<float>(layer, j, pose);
      else if (weight_of(layer, j) == 1)
        pose[j] = layer.pose[j];
  });
  return true;
}

void take_difference(const PoseSpace& space, const mcpr_transform* pose, const mcpr_transform* base,
                     std::uint32_t joints, mcpr_transform* out) {
  for_joints(joints, [&](auto real, std::uint32_t j) {
    using Real = decltype(real);
    const Placed<Real> to = space.load<Real>(pose + j);
    const Placed<Real> from = space.load<Real>(base + j);
    space.store<Real>({normalised(to.turn * inverse(from.turn)), to.shift - from.shift}, out + j);
  });
}

bool add_difference(const PoseSpace& space, const mcpr_weighted_pose& difference,
                    std::uint32_t joints, mcpr_transform* pose) {
  if (!are_weights(difference, joints, 1)) return false;
  const auto add = [&](auto real, std::uint32_t j) {
    using Real = decltype(real);
    const Real weight = weights_of<Real>(difference, j);
    const Placed<Real> added = space.load<Real>(difference.pose + j);
    const Placed<Real> to = space.load<Real>(pose + j);
    space.store<Real>(
        {normalised(part_of(added.turn, weight) * to.turn), to.shift + weight * added.shift},
        pose + j);
  };
  for_joints(joints, [&](auto real, std::uint32_t first) {
    using Real = decltype(real);
    bool all_turn = true;
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      all_turn = all_turn && weight_of(difference, j) > 0;
    if (all_turn) return add(real, first);
    for (std::uint32_t j = first; j < first + kJointsOf<Real>; ++j)
      if (weight_of(difference, j) > 0) add(float{}, j);
  });
  return true;
}

void split_root(const PoseSpace& space, mcpr_transform& root, mcpr_transform& ground) {
  constexpr float kNowhere = 1e-12F;
  const Placed<float> placed = space.load<float>(&root);
  const auto& [turn, shift] = placed;
  const int up = space.up;
  Turn<float> about_up{turn.w, up == 0 ? turn.x : 0, up == 1 ? turn.y : 0, up == 2 ? turn.z : 0};
  about_up = dot(about_up, about_up) > kNowhere ? normalised(about_up) : Turn<float>{1, 0, 0, 0};
  const Shift<float> height{up == 0 ? shift.x : 0, up == 1 ? shift.y : 0, up == 2 ? shift.z : 0};
  space.store<float>({about_up, shift - height}, &ground);
  space.store<float>({inverse(about_up) * turn, height}, &root);
}

bool are_partners(const std::uint16_t* partners, const std::int16_t* parents,
                  std::uint32_t joints) {
  for (std::uint32_t j = 0; j < joints; ++j)
    if (partners[j] >= joints || partners[partners[j]] != j) return false;
  for (std::uint32_t j = 0; j < joints; ++j) {
    const int parent = parents[j];
    if (parents[partners[j]] != (parent < 0 ? -1 : partners[parent])) return false;
  }
  return true;
}

void make_mirror(const PoseSpace& space, const mcpr_transform* bind, const std::int16_t* parents,
                 const std::uint16_t* partners, int axis, std::uint32_t joints,
                 mcpr_mirror_joint* mirror) {
  for (std::uint32_t j = 0; j < joints; ++j) {
    const Placed<float> partner{turn_in_model(space, bind, parents, partners[j]), {0, 0, 0}};
    const Turn<float> image = mirrored(partner, axis).turn;
    mirror[j] = {partners[j], {1, 0, 0, 0}, {}};
    keep_turn(normalised(inverse(image) * turn_in_model(space, bind, parents, j)), mirror[j].after);
    if (parents[j] >= 0)
      keep_turn(inverse(constant_turn(mirror[parents[j]].after)), mirror[j].before);
  }
}

void mirror_pose(const PoseSpace& space, const mcpr_mirror_joint* mirror, int axis,
                 const mcpr_transform* pose, std::uint32_t joints, mcpr_transform* out) {
  for_joints(joints, [&](auto real, std::uint32_t first) {
    using Real = decltype(real);
    mcpr_transform partners[kJointsOf<Real>];
    mcpr_transform around[2][kJointsOf<Real>] = {};  // arrays of transforms, because these can be
                                                     // loaded as poses are
    for (std::uint32_t i = 0; i < kJointsOf<Real>; ++i) {
      const mcpr_mirror_joint& joint = mirror[first + i];
      partners[i] = pose[joint.partner];
      std::copy_n(joint.before, 4, around[0][i].rotation);
      std::copy_n(joint.after, 4, around[1][i].rotation);
    }
    const Placed<Real> image = mirrored(space.load<Real>(partners), axis);
    const Turn<Real> before = Placed<Real>::load(around[0]).turn;
    const Turn<Real> after = Placed<Real>::load(around[1]).turn;
    space.store<Real>({normalised(before * image.turn * after), turned(before, image.shift)},
                      out + first);
  });
}

}  // namespace mocapress::runtime
