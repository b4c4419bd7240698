// SPDX-License-Identifier: MIT
// Blends poses of mcpr_transform. mocapress_runtime.h says what each function does.
#pragma once

#include <cstdint>

#include "core/runtime/mocapress_runtime.h"
#include "core/runtime/pose/turn.h"

namespace mocapress::runtime {

/// The parts of a convention that blends depend on: the place of w in quaternions, and the axis
/// that is up.
struct PoseSpace {
  bool w_last = false;
  int up = 1;  // number of the axis that points up, or down

  explicit PoseSpace(const mcpr_convention* convention);

  template <typename Real>
  Placed<Real> load(const mcpr_transform* from) const {
    Placed<Real> placed = Placed<Real>::load(from);
    const Turn<Real> q = placed.turn;
    if (w_last) placed.turn = {q.z, q.w, q.x, q.y};
    return placed;
  }
  template <typename Real>
  void store(Placed<Real> placed, mcpr_transform* to) const {
    const Turn<Real> q = placed.turn;
    if (w_last) placed.turn = {q.x, q.y, q.z, q.w};
    placed.store(to);
  }
};

/// These return false if a weight is out of range.
bool blend(const mcpr_weighted_pose* poses, std::uint32_t count, std::uint32_t joints,
           mcpr_transform* out);
bool blend_layer(const mcpr_weighted_pose& layer, std::uint32_t joints, mcpr_transform* pose);
bool add_difference(const PoseSpace& space, const mcpr_weighted_pose& difference,
                    std::uint32_t joints, mcpr_transform* pose);

void take_difference(const PoseSpace& space, const mcpr_transform* pose, const mcpr_transform* base,
                     std::uint32_t joints, mcpr_transform* out);

void split_root(const PoseSpace& space, mcpr_transform& root, mcpr_transform& ground);

/// True if each partner's partner is the joint itself, and partners have partners as parents.
bool are_partners(const std::uint16_t* partners, const std::int16_t* parents, std::uint32_t joints);
void make_mirror(const PoseSpace& space, const mcpr_transform* bind, const std::int16_t* parents,
                 const std::uint16_t* partners, int axis, std::uint32_t joints,
                 mcpr_mirror_joint* mirror);
void mirror_pose(const PoseSpace& space, const mcpr_mirror_joint* mirror, int axis,
                 const mcpr_transform* pose, std::uint32_t joints, mcpr_transform* out);

}  // namespace mocapress::runtime
