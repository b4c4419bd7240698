// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, section 5.3 (the recursive
// Newton-Euler algorithm) with chapter 6's composite bodies, and small displacements for
// velocities.
//
// A figure as a linkage that carries weighted landmarks. Errors of channels move what hangs on
// their joints, and the squares of these movements, weighed, are an energy: its slope in a channel
// is the work of the forces that the movements call up. What follows does that joint by joint, for
// eight frames at a time, in the instruction set that the machine has. In the world, cm and
// radians.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace mocapress {

/// A number of eight frames.
struct alignas(32) EightFrames {
  static constexpr Eigen::Index kCount = 8;
  std::array<float, kCount> of_frame{};
};

/// A joint at each frame. Its numbers lie as they are read: all of eight frames, then all of the
/// next eight.
struct LinkageJoint {
  static constexpr int kArm = 0;      // from its parent to it: x y z
  static constexpr int kMoment = 3;   // of all it moves, seen from it: sum of weight times place
  static constexpr int kInertia = 6;  // likewise, about x y z: weight times (yy + zz), ...
  static constexpr int kMixed = 9;    // weight times yz, zx, xy
  static constexpr int kAxes = 12;    // x y z of each of its channels: turn or shift of a unit

  int parent;  // -1: none
  int first_channel;
  float mass = 0;                   // the weights of all it moves
  bool shifts = false;              // any of its channels
  bool is_leaf = true;              // no joint hangs on it
  bool is_last_child = true;        // of its parent
  std::vector<std::uint8_t> turns;  // of each of its channels: whether it turns
  std::vector<EightFrames> numbers{};

  int end_channel() const { return first_channel + static_cast<int>(std::ssize(turns)); }
  Eigen::Index stride() const { return kAxes + 3 * std::ssize(turns); }

  int axis_of(int channel) const { return kAxes + 3 * (channel - first_channel); }

  /// Three numbers of a frame.
  void set(Eigen::Index frame, int which, const Eigen::Vector3d& three) {
    for (int i = 0; i < 3; ++i)
      numbers[eight_of(frame, which + i)].of_frame[lane_of(frame)] = static_cast<float>(three(i));
  }
  Eigen::Vector3d at(Eigen::Index frame, int which) const {
    Eigen::Vector3d three;
    for (int i = 0; i < 3; ++i)
      three(i) = static_cast<double>(numbers[eight_of(frame, which + i)].of_frame[lane_of(frame)]);
    return three;
  }

  std::size_t eight_of(Eigen::Index frame, int which) const {
    return static_cast<std::size_t>(frame / EightFrames::kCount * stride() + which);
  }
  static std::size_t lane_of(Eigen::Index frame) {
    return static_cast<std::size_t>(frame % EightFrames::kCount);
  }
};

/// What errors do to a joint, of one eight frames after the other: how it moves, and the forces
/// that this calls up in what it moves, about it.
struct JointState {
  std::array<EightFrames, 3> turn, shift, torque, force;
};

/// Frames of a linkage, from a multiple of eight on.
struct FrameRange {
  Eigen::Index first;
  Eigen::Index count;

  Eigen::Index eights() const { return (count + EightFrames::kCount - 1) / EightFrames::kCount; }
};

/// Errors of channels: a column for each.
struct ErrorColumns {
  const float* first;
  Eigen::Index stride;
};

// Of all these, states are those of the range alone.

/// From the leaves up, the last joint first: adds to the forces on the parent (null: there is none)
/// what the joint's own errors call up and what joints below have handed up to `state`, and to the
/// energies (one a frame, to a whole number of eights) what these errors bring.
void hand_up(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
             const JointState* state, JointState* parent, float* energies);

/// The forces on the parent become those on the joint, with no others.
void hand_up(const LinkageJoint& joint, FrameRange frames, const JointState* state,
             JointState* parent);

/// From the root down: the joint moves as its parent does, and as its own errors have it. The
/// forces on it, which so far are those that joints below handed up, become those of all movements.
void enter(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
           const JointState* parent, JointState* state);

/// The same of a joint that only its parent moves and nothing was handed up to.
void enter(const LinkageJoint& joint, FrameRange frames, const JointState* parent,
           JointState* state);

/// What a unit of a channel works against the forces on its joint, one number a frame, to a whole
/// number of eights.
void find_work(const LinkageJoint& joint, int channel, FrameRange frames, const JointState* state,
               float* work);

/// The error of a channel grows: so do the joint's movement and, unless nobody asks for them any
/// more, the forces on it.
void add_error(const LinkageJoint& joint, int channel, const float* delta, FrameRange frames,
               bool forces, JointState* state);

}  // namespace mocapress
