// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, section 5.3 (the recursive
// Newton-Euler algorithm) with chapter 6's composite bodies, and small displacements for
// velocities.
//
// A figure as a linkage that carries weighted landmarks. Errors of channels move the landmarks on
// the joints below, and the weighted squares of these movements are an energy. The energy's slope
// in a channel is the work of the forces that the movements cause. The functions below compute that
// joint by joint, for eight frames at a time, in the machine's best instruction set. World space,
// cm and radians.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace mocapress {

/// One number at each of eight frames.
struct alignas(32) EightFrames {
  static constexpr Eigen::Index kCount = 8;
  std::array<float, kCount> of_frame{};
};

/// A joint with its numbers at each frame. They are stored in the order in which they are read: all
/// numbers of eight frames, then all of the next eight.
struct LinkageJoint {
  static constexpr int kArm = 0;      // from its parent to it: x y z
  static constexpr int kMoment = 3;   // sum of weight times place over all it moves, relative to it
  static constexpr int kInertia = 6;  // likewise, about x y z: weight times (yy + zz), ...
  static constexpr int kMixed = 9;    // weight times yz, zx, xy
  static constexpr int kAxes = 12;    // each channel's turn or shift for one unit: x y z

  int parent;  // -1: none
  int first_channel;
  float mass = 0;                   // sum of the weights it moves
  bool shifts = false;              // one of its channels translates
  bool is_leaf = true;              // no joint is its child
  bool is_last_child = true;        // its parent's last child
  std::vector<std::uint8_t> turns;  // one for each channel: 1 if it rotates
  std::vector<EightFrames> numbers{};

  int end_channel() const { return first_channel + static_cast<int>(std::ssize(turns)); }
  Eigen::Index stride() const { return kAxes + 3 * std::ssize(turns); }

  int axis_of(int channel) const { return kAxes + 3 * (channel - first_channel); }

  /// Sets or gets three numbers at a frame.
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

/// A joint's state over eight frames: its movement, and the forces that act at the joint because
/// the landmarks that it carries move.
struct JointState {
  std::array<EightFrames, 3> turn, shift, torque, force;
};

/// A range of frames that begins at a multiple of eight.
struct FrameRange {
  Eigen::Index first;
  Eigen::Index count;

  Eigen::Index eights() const { return (count + EightFrames::kCount - 1) / EightFrames::kCount; }
};

/// Errors of channels, one column each.
struct ErrorColumns {
  const float* first;
  Eigen::Index stride;
};

// In the functions below, states cover only the frames in the given range.

/// The pass from the leaves up, last joint first. Adds the forces from the joint's own errors, and
/// those that joints below have handed to `state`, to the parent's (null: none). Adds the energy of
/// these errors to `energies` (one a frame, rounded up to a multiple of eight).
void hand_up(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
             const JointState* state, JointState* parent, float* energies);

/// Sets the parent's forces to those that this joint hands up, without errors of its own.
void hand_up(const LinkageJoint& joint, FrameRange frames, const JointState* state,
             JointState* parent);

/// The pass from the root down. The joint takes its parent's movement and adds its own errors'. Its
/// forces, so far those that joints below handed up, become those of all movements.
void enter(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
           const JointState* parent, JointState* state);

/// enter() for a joint without errors of its own and without forces from joints below.
void enter(const LinkageJoint& joint, FrameRange frames, const JointState* parent,
           JointState* state);

/// The work of one unit of a channel against the forces on its joint, one number a frame, rounded
/// up to a multiple of eight.
void find_work(const LinkageJoint& joint, int channel, FrameRange frames, const JointState* state,
               float* work);

/// Raises the error of a channel, and with it the joint's movement and, if `forces`, the forces on
/// it.
void add_error(const LinkageJoint& joint, int channel, const float* delta, FrameRange frames,
               bool forces, JointState* state);

}  // namespace mocapress
