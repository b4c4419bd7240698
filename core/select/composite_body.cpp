// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6 (composite rigid
// bodies).
#include "core/select/composite_body.h"

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

template <typename Vector>
struct Three {
  Vector x, y, z;
};

template <typename Vector>
MOCAPRESS_INLINE void load_three(const ThreeColumns& from, int t, Three<Vector>& three) {
  load(from[0] + t, three.x);
  load(from[1] + t, three.y);
  load(from[2] + t, three.z);
}

template <typename Vector>
MOCAPRESS_INLINE void load_three(const std::array<CompositeBody::Column, 3>& from, int t,
                                 Three<Vector>& three) {
  load_three({from[0].data(), from[1].data(), from[2].data()}, t, three);
}

template <typename Vector>
MOCAPRESS_INLINE void subtract(const Three<Vector>& less, Three<Vector>& three) {
  three.x -= less.x;
  three.y -= less.y;
  three.z -= less.z;
}

template <typename Vector>
MOCAPRESS_INLINE void cross(const Three<Vector>& a, const Three<Vector>& b,
                            Three<Vector>& product) {
  product.x = a.y * b.z - a.z * b.y;
  product.y = a.z * b.x - a.x * b.z;
  product.z = a.x * b.y - a.y * b.x;
}

template <typename Vector>
MOCAPRESS_INLINE void increase(CompositeBody::Column& column, int t, const Vector& by) {
  Vector sum;
  load(column.data() + t, sum);
  store<Vector>(sum + by, column.data() + t);
}

MOCAPRESS_INLINE void store_as_floats(const Doubles4& vector, float* to) {
  store<Floats4>(__builtin_convertvector(vector, Floats4), to);
}
MOCAPRESS_INLINE void store_as_floats(const Doubles2& vector, float* to) {
  to[0] = static_cast<float>(vector[0]);
  to[1] = static_cast<float>(vector[1]);
}
MOCAPRESS_INLINE void store_as_floats(const Doubles1& vector, float* to) {
  *to = static_cast<float>(vector);
}

// Each does as many frames as make up vectors, and returns the first that is left over.

template <typename Vector>
MOCAPRESS_INLINE int add_points(CompositeBody& body, double weight, const ThreeColumns& places,
                                const ThreeColumns& origin, int t, int frames) {
  for (; t + kLanes<Vector, double> <= frames; t += kLanes<Vector, double>) {
    Three<Vector> seen_from;
    Three<Vector> place;
    load_three(origin, t, seen_from);
    load_three(places, t, place);
    subtract(seen_from, place);
    const Vector x = weight * place.x;
    const Vector y = weight * place.y;
    const Vector z = weight * place.z;
    increase<Vector>(body.moment[0], t, x);
    increase<Vector>(body.moment[1], t, y);
    increase<Vector>(body.moment[2], t, z);
    increase<Vector>(body.square[0], t, x * place.x);
    increase<Vector>(body.square[1], t, y * place.y);
    increase<Vector>(body.square[2], t, z * place.z);
    increase<Vector>(body.mixed[0], t, y * place.z);
    increase<Vector>(body.mixed[1], t, z * place.x);
    increase<Vector>(body.mixed[2], t, x * place.y);
  }
  return t;
}

/// `turn`: about the origin; else there is none, and `shift` is all.
template <typename Vector, bool turns>
MOCAPRESS_INLINE void respond(const CompositeBody& body, const Three<Vector>& turn,
                              const Three<Vector>& shift, int t, const ChannelResponse& response) {
  Three<Vector> moment;
  load_three(body.moment, t, moment);
  Three<Vector> torque;
  cross(moment, shift, torque);
  Three<Vector> force = {body.mass * shift.x, body.mass * shift.y, body.mass * shift.z};
  Vector work;
  if constexpr (turns) {
    Three<Vector> of_turn;
    cross(turn, moment, of_turn);
    force.x += of_turn.x;
    force.y += of_turn.y;
    force.z += of_turn.z;
    Three<Vector> square;
    Three<Vector> mixed;
    load_three(body.square, t, square);
    load_three(body.mixed, t, mixed);
    torque.x += (square.y + square.z) * turn.x - mixed.z * turn.y - mixed.y * turn.z;
    torque.y += (square.z + square.x) * turn.y - mixed.x * turn.z - mixed.z * turn.x;
    torque.z += (square.x + square.y) * turn.z - mixed.y * turn.x - mixed.x * turn.y;
    work = turn.x * torque.x + turn.y * torque.y + turn.z * torque.z + shift.x * force.x +
           shift.y * force.y + shift.z * force.z;
  } else {
    work = shift.x * force.x + shift.y * force.y + shift.z * force.z;
  }
  store_as_floats(turn.x, response.motion[0] + t);
  store_as_floats(turn.y, response.motion[1] + t);
  store_as_floats(turn.z, response.motion[2] + t);
  store_as_floats(shift.x, response.motion[3] + t);
  store_as_floats(shift.y, response.motion[4] + t);
  store_as_floats(shift.z, response.motion[5] + t);
  store_as_floats(torque.x, response.force[0] + t);
  store_as_floats(torque.y, response.force[1] + t);
  store_as_floats(torque.z, response.force[2] + t);
  store_as_floats(force.x, response.force[3] + t);
  store_as_floats(force.y, response.force[4] + t);
  store_as_floats(force.z, response.force[5] + t);
  store(work, response.curvature + t);
}

template <typename Vector>
MOCAPRESS_INLINE int turn_body(const CompositeBody& body, const ThreeColumns& axis,
                               const ThreeColumns& joint_origin, const ThreeColumns& origin, int t,
                               int frames, const ChannelResponse& response) {
  for (; t + kLanes<Vector, double> <= frames; t += kLanes<Vector, double>) {
    Three<Vector> turn;
    Three<Vector> place;
    Three<Vector> seen_from;
    load_three(axis, t, turn);
    load_three(joint_origin, t, place);
    load_three(origin, t, seen_from);
    subtract(seen_from, place);
    Three<Vector> shift;
    cross(place, turn, shift);
    respond<Vector, true>(body, turn, shift, t, response);
  }
  return t;
}

template <typename Vector>
MOCAPRESS_INLINE int shift_body(const CompositeBody& body, const ThreeColumns& axis, int t,
                                int frames, const ChannelResponse& response) {
  for (; t + kLanes<Vector, double> <= frames; t += kLanes<Vector, double>) {
    Three<Vector> shift;
    load_three(axis, t, shift);
    respond<Vector, false>(body, Three<Vector>{}, shift, t, response);
  }
  return t;
}

#ifdef MOCAPRESS_WITH_AVX2
MOCAPRESS_FOR_AVX2 int add_points_with_avx2(CompositeBody& body, double weight,
                                            const ThreeColumns& places, const ThreeColumns& origin,
                                            int frames) {
  return add_points<Doubles4>(body, weight, places, origin, 0, frames);
}
MOCAPRESS_FOR_AVX2 int turn_body_with_avx2(const CompositeBody& body, const ThreeColumns& axis,
                                           const ThreeColumns& joint_origin,
                                           const ThreeColumns& origin, int frames,
                                           const ChannelResponse& response) {
  return turn_body<Doubles4>(body, axis, joint_origin, origin, 0, frames, response);
}
#endif

}  // namespace

void CompositeBody::add(double weight, const ThreeColumns& places, const ThreeColumns& origin,
                        int frames) {
  mass += weight;
  int t = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) t = add_points_with_avx2(*this, weight, places, origin, frames);
#endif
  t = add_points<Doubles2>(*this, weight, places, origin, t, frames);
  add_points<Doubles1>(*this, weight, places, origin, t, frames);
}

void CompositeBody::add(const CompositeBody& other, int frames) {
  mass += other.mass;
  const auto add_three = [frames](const std::array<Column, 3>& more, std::array<Column, 3>& to) {
    for (std::size_t i = 0; i < to.size(); ++i)
      for (std::size_t t = 0; t < static_cast<std::size_t>(frames); ++t) to[i][t] += more[i][t];
  };
  add_three(other.moment, moment);
  add_three(other.square, square);
  add_three(other.mixed, mixed);
}

void turn_body(const CompositeBody& body, const ThreeColumns& axis,
               const ThreeColumns& joint_origin, const ThreeColumns& origin, int frames,
               const ChannelResponse& response) {
  int t = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) t = turn_body_with_avx2(body, axis, joint_origin, origin, frames, response);
#endif
  t = turn_body<Doubles2>(body, axis, joint_origin, origin, t, frames, response);
  turn_body<Doubles1>(body, axis, joint_origin, origin, t, frames, response);
}

void shift_body(const CompositeBody& body, const ThreeColumns& axis, int frames,
                const ChannelResponse& response) {
  const int t = shift_body<Doubles2>(body, axis, 0, frames, response);
  shift_body<Doubles1>(body, axis, t, frames, response);
}

}  // namespace mocapress
