// SPDX-License-Identifier: MIT
#include "core/select/linkage.h"

#include "core/base/instruction_sets.h"
#include "core/select/three.h"

namespace mocapress {
namespace {

constexpr Eigen::Index kEight = EightFrames::kCount;

/// The work on one joint in a pass over the linkage.
struct Task {
  const LinkageJoint& joint;
  FrameRange frames;
  ErrorColumns errors{};

  const EightFrames* numbers(Eigen::Index eight) const {
    return joint.numbers.data() + (frames.first / kEight + eight) * joint.stride();
  }
  const float* error(Eigen::Index channel) const {
    return errors.first + (joint.first_channel + channel) * errors.stride + frames.first;
  }
};

// Below, `part` is a vector's first frame within its group of eight.

template <typename Vector>
MOCAPRESS_INLINE void load_three(const EightFrames* from, int part, Three<Vector>& three) {
  load(from[0].of_frame.data() + part, three.x);
  load(from[1].of_frame.data() + part, three.y);
  load(from[2].of_frame.data() + part, three.z);
}

template <typename Vector>
MOCAPRESS_INLINE void store_three(const Three<Vector>& three, int part,
                                  std::array<EightFrames, 3>& to) {
  store(three.x, to[0].of_frame.data() + part);
  store(three.y, to[1].of_frame.data() + part);
  store(three.z, to[2].of_frame.data() + part);
}

/// Loads up to `count` numbers; the rest of the vector is zero.
template <typename Vector>
MOCAPRESS_INLINE void load_some(const float* from, Eigen::Index count, Vector& vector) {
  if (count >= kLanes<Vector, float>) {
    load(from, vector);
    return;
  }
  std::array<float, kLanes<Vector, float>> padded{};
  for (Eigen::Index i = 0; i < count; ++i) padded[i] = from[i];
  load(padded.data(), vector);
}

/// Adds the errors of a joint's own channels to its movement.
template <typename Vector, bool kShifts>
MOCAPRESS_INLINE void add_errors(const Task& task, Eigen::Index eight, int part,
                                 Three<Vector>& turn, Three<Vector>& shift) {
  const LinkageJoint& joint = task.joint;
  const EightFrames* const axes = task.numbers(eight) + LinkageJoint::kAxes;
  const Eigen::Index frame = kEight * eight + part;
  for (Eigen::Index c = 0; c < std::ssize(joint.turns); ++c) {
    Vector error;
    Three<Vector> axis;
    load_some(task.error(c) + frame, task.frames.count - frame, error);
    load_three(axes + 3 * c, part, axis);
    add_product(error, axis, !kShifts || joint.turns[c] ? turn : shift);
  }
}

/// The torque about the joint that a movement causes.
template <typename Vector>
MOCAPRESS_INLINE void find_torque(const EightFrames* numbers, int part, const Three<Vector>& turn,
                                  const Three<Vector>& shift, Three<Vector>& torque) {
  Three<Vector> moment;
  Three<Vector> inertia;
  Three<Vector> mixed;
  load_three(numbers + LinkageJoint::kMoment, part, moment);
  load_three(numbers + LinkageJoint::kInertia, part, inertia);
  load_three(numbers + LinkageJoint::kMixed, part, mixed);
  cross(moment, shift, torque);
  torque.x += inertia.x * turn.x - mixed.z * turn.y - mixed.y * turn.z;
  torque.y += inertia.y * turn.y - mixed.x * turn.z - mixed.z * turn.x;
  torque.z += inertia.z * turn.z - mixed.y * turn.x - mixed.x * turn.y;
}

template <typename Vector>
MOCAPRESS_INLINE void find_force(const LinkageJoint& joint, const EightFrames* numbers, int part,
                                 const Three<Vector>& turn, const Three<Vector>& shift,
                                 Three<Vector>& force) {
  Three<Vector> moment;
  load_three(numbers + LinkageJoint::kMoment, part, moment);
  cross(turn, moment, force);
  add_product(joint.mass - Vector{}, shift, force);
}

/// Adds a torque and a force to the parent's, relative to the parent.
template <typename Vector>
MOCAPRESS_INLINE void add_to_parent(const EightFrames* numbers, int part,
                                    const Three<Vector>& torque, const Three<Vector>& force,
                                    bool is_first, JointState& parent) {
  Three<Vector> arm;
  Three<Vector> seen_from_parent;
  load_three(numbers + LinkageJoint::kArm, part, arm);
  cross(arm, force, seen_from_parent);
  add(torque, seen_from_parent);
  Three<Vector> sum = force;
  if (!is_first) {
    Three<Vector> before;
    load_three(parent.torque.data(), part, before);
    add(before, seen_from_parent);
    load_three(parent.force.data(), part, before);
    add(before, sum);
  }
  store_three(seen_from_parent, part, parent.torque);
  store_three(sum, part, parent.force);
}

template <typename Vector, bool kShifts>
MOCAPRESS_INLINE void hand_up_of(const Task& task, const JointState* state, JointState* parent,
                                 float* energies) {
  for (Eigen::Index eight = 0; eight < task.frames.eights(); ++eight)
    for (int part = 0; part < kEight; part += kLanes<Vector, float>) {
      const EightFrames* const numbers = task.numbers(eight);
      Three<Vector> turn{};
      Three<Vector> shift{};
      add_errors<Vector, kShifts>(task, eight, part, turn, shift);
      Three<Vector> torque;
      Three<Vector> force;
      find_torque(numbers, part, turn, shift, torque);
      find_force(task.joint, numbers, part, turn, shift, force);
      Three<Vector> torque_below{};
      Three<Vector> force_below{};
      if (!task.joint.is_leaf) {
        load_three(state[eight].torque.data(), part, torque_below);
        load_three(state[eight].force.data(), part, force_below);
      }
      add(torque_below, torque);
      add(force_below, force);
      // Adds the energy of the joint's own errors, plus twice their work against the forces from
      // below.
      Vector energy;
      Vector work;
      load(energies + kEight * eight + part, energy);
      add(torque, torque_below);
      dot(turn, torque_below, work);
      energy += work;
      if constexpr (kShifts) {
        add(force, force_below);
        dot(shift, force_below, work);
        energy += work;
      }
      store(energy, energies + kEight * eight + part);
      if (parent)
        add_to_parent(numbers, part, torque, force, task.joint.is_last_child, parent[eight]);
    }
}

template <typename Vector>
MOCAPRESS_INLINE void hand_up_of(const Task& task, const JointState* state, JointState* parent) {
  for (Eigen::Index eight = 0; eight < task.frames.eights(); ++eight)
    for (int part = 0; part < kEight; part += kLanes<Vector, float>) {
      Three<Vector> torque;
      Three<Vector> force;
      load_three(state[eight].torque.data(), part, torque);
      load_three(state[eight].force.data(), part, force);
      add_to_parent(task.numbers(eight), part, torque, force, true, parent[eight]);
    }
}

template <typename Vector, bool kShifts, bool kHasErrors>
MOCAPRESS_INLINE void enter_of(const Task& task, const JointState* parent, JointState* state) {
  for (Eigen::Index eight = 0; eight < task.frames.eights(); ++eight)
    for (int part = 0; part < kEight; part += kLanes<Vector, float>) {
      const EightFrames* const numbers = task.numbers(eight);
      Three<Vector> turn{};
      Three<Vector> shift{};
      if (parent) {
        Three<Vector> arm;
        Three<Vector> of_parent;
        load_three(parent[eight].turn.data(), part, turn);
        load_three(numbers + LinkageJoint::kArm, part, arm);
        cross(turn, arm, shift);
        load_three(parent[eight].shift.data(), part, of_parent);
        add(of_parent, shift);
      }
      if constexpr (kHasErrors) add_errors<Vector, kShifts>(task, eight, part, turn, shift);
      store_three(turn, part, state[eight].turn);
      store_three(shift, part, state[eight].shift);
      Three<Vector> below;
      Three<Vector> torque;
      find_torque(numbers, part, turn, shift, torque);
      if (kHasErrors && !task.joint.is_leaf) {
        load_three(state[eight].torque.data(), part, below);
        add(below, torque);
      }
      store_three(torque, part, state[eight].torque);
      if constexpr (kShifts) {
        Three<Vector> force;
        find_force(task.joint, numbers, part, turn, shift, force);
        if (kHasErrors && !task.joint.is_leaf) {
          load_three(state[eight].force.data(), part, below);
          add(below, force);
        }
        store_three(force, part, state[eight].force);
      }
    }
}

template <typename Vector>
MOCAPRESS_INLINE void find_work_of(const Task& task, Eigen::Index channel, const JointState* state,
                                   float* work) {
  const bool turns = task.joint.turns[channel] != 0;
  for (Eigen::Index eight = 0; eight < task.frames.eights(); ++eight)
    for (int part = 0; part < kEight; part += kLanes<Vector, float>) {
      Three<Vector> axis;
      Three<Vector> against;
      Vector product;
      load_three(task.numbers(eight) + LinkageJoint::kAxes + 3 * channel, part, axis);
      load_three((turns ? state[eight].torque : state[eight].force).data(), part, against);
      dot(axis, against, product);
      store(product, work + kEight * eight + part);
    }
}

/// Adds to a sum in memory.
template <typename Vector>
MOCAPRESS_INLINE void increase(const Three<Vector>& by, int part, std::array<EightFrames, 3>& sum) {
  Three<Vector> before;
  load_three(sum.data(), part, before);
  add(by, before);
  store_three(before, part, sum);
}

template <typename Vector, bool kTurns, bool kForces>
MOCAPRESS_INLINE void add_error_of(const Task& task, Eigen::Index channel, const float* delta,
                                   JointState* state) {
  for (Eigen::Index eight = 0; eight < task.frames.eights(); ++eight)
    for (int part = 0; part < kEight; part += kLanes<Vector, float>) {
      const EightFrames* const numbers = task.numbers(eight);
      const Eigen::Index frame = kEight * eight + part;
      Vector error;
      Three<Vector> axis;
      load_some(delta + frame, task.frames.count - frame, error);
      load_three(numbers + LinkageJoint::kAxes + 3 * channel, part, axis);
      Three<Vector> turn{};
      Three<Vector> shift{};
      add_product(error, axis, kTurns ? turn : shift);
      increase(kTurns ? turn : shift, part, kTurns ? state[eight].turn : state[eight].shift);
      if constexpr (kForces) {
        Three<Vector> torque;
        Three<Vector> force;
        find_torque(numbers, part, turn, shift, torque);
        find_force(task.joint, numbers, part, turn, shift, force);
        increase(torque, part, state[eight].torque);
        increase(force, part, state[eight].force);
      }
    }
}

template <typename Vector>
MOCAPRESS_INLINE void hand_up_with(const Task& task, const JointState* state, JointState* parent,
                                   float* energies) {
  if (task.joint.shifts)
    hand_up_of<Vector, true>(task, state, parent, energies);
  else
    hand_up_of<Vector, false>(task, state, parent, energies);
}

template <typename Vector>
MOCAPRESS_INLINE void enter_with(const Task& task, const JointState* parent, JointState* state) {
  if (!task.errors.first)
    task.joint.shifts ? enter_of<Vector, true, false>(task, parent, state)
                      : enter_of<Vector, false, false>(task, parent, state);
  else
    task.joint.shifts ? enter_of<Vector, true, true>(task, parent, state)
                      : enter_of<Vector, false, true>(task, parent, state);
}

template <typename Vector>
MOCAPRESS_INLINE void add_error_with(const Task& task, Eigen::Index channel, const float* delta,
                                     bool forces, JointState* state) {
  if (task.joint.turns[channel] != 0)
    forces ? add_error_of<Vector, true, true>(task, channel, delta, state)
           : add_error_of<Vector, true, false>(task, channel, delta, state);
  else
    forces ? add_error_of<Vector, false, true>(task, channel, delta, state)
           : add_error_of<Vector, false, false>(task, channel, delta, state);
}

void enter(const Task& task, const JointState* parent, JointState* state) {
  if (!with_avx2([&]() MOCAPRESS_INLINED { enter_with<Floats8>(task, parent, state); }))
    enter_with<Floats4>(task, parent, state);
}

}  // namespace

void hand_up(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
             const JointState* state, JointState* parent, float* energies) {
  const Task task{joint, frames, errors};
  if (!with_avx2([&]() MOCAPRESS_INLINED { hand_up_with<Floats8>(task, state, parent, energies); }))
    hand_up_with<Floats4>(task, state, parent, energies);
}

void hand_up(const LinkageJoint& joint, FrameRange frames, const JointState* state,
             JointState* parent) {
  hand_up_of<Floats4>({joint, frames}, state, parent);
}

void enter(const LinkageJoint& joint, ErrorColumns errors, FrameRange frames,
           const JointState* parent, JointState* state) {
  enter({joint, frames, errors}, parent, state);
}

void enter(const LinkageJoint& joint, FrameRange frames, const JointState* parent,
           JointState* state) {
  enter({joint, frames}, parent, state);
}

void find_work(const LinkageJoint& joint, int channel, FrameRange frames, const JointState* state,
               float* work) {
  const Task task{joint, frames};
  const Eigen::Index own = channel - joint.first_channel;
  if (!with_avx2([&]() MOCAPRESS_INLINED { find_work_of<Floats8>(task, own, state, work); }))
    find_work_of<Floats4>(task, own, state, work);
}

void add_error(const LinkageJoint& joint, int channel, const float* delta, FrameRange frames,
               bool forces, JointState* state) {
  const Task task{joint, frames};
  const Eigen::Index own = channel - joint.first_channel;
  const auto add_longer = [&]() MOCAPRESS_INLINED {
    add_error_with<Floats8>(task, own, delta, forces, state);
  };
  if (!with_avx2(add_longer)) add_error_with<Floats4>(task, own, delta, forces, state);
}

}  // namespace mocapress
