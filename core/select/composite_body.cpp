// SPDX-License-Identifier: MIT
// Based on: R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6 (composite rigid
// bodies).
#include "core/select/composite_body.h"

#include "core/base/instruction_sets.h"
#include "core/select/three.h"

namespace mocapress {
namespace {

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

/// Loads places relative to `origin`.
template <typename Vector>
MOCAPRESS_INLINE void load_place(const ThreeColumns& places, const ThreeColumns& origin, int t,
                                 Three<Vector>& place) {
  Three<Vector> seen_from;
  load_three(origin, t, seen_from);
  load_three(places, t, place);
  subtract(seen_from, place);
}

template <typename Vector>
MOCAPRESS_INLINE void store_three(const Three<Vector>& three, int t,
                                  std::array<CompositeBody::Column, 3>& to) {
  store(three.x, to[0].data() + t);
  store(three.y, to[1].data() + t);
  store(three.z, to[2].data() + t);
}

template <typename Vector>
MOCAPRESS_INLINE void increase(CompositeBody::Column& column, int t, const Vector& by) {
  Vector sum;
  load(column.data() + t, sum);
  store<Vector>(sum + by, column.data() + t);
}

// The functions below handle as many frames as fill whole vectors, and return the first frame left
// over.

template <typename Vector>
MOCAPRESS_INLINE int add_points(CompositeBody& body, double weight, const ThreeColumns& places,
                                const ThreeColumns& origin, int t, int frames) {
  for (; t + kLanes<Vector, double> <= frames; t += kLanes<Vector, double>) {
    Three<Vector> place;
    load_place(places, origin, t, place);
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

template <typename Vector>
MOCAPRESS_INLINE int move_origin(const CompositeBody& body, const ThreeColumns& place,
                                 const ThreeColumns& origin, int t, int frames,
                                 CompositeBody& moved) {
  for (; t + kLanes<Vector, double> <= frames; t += kLanes<Vector, double>) {
    Three<Vector> by;
    load_place(place, origin, t, by);
    Three<Vector> before;
    load_three(body.moment, t, before);
    Three<Vector> moment = before;
    add_product(Vector{} - body.mass, by, moment);
    Three<Vector> square;
    load_three(body.square, t, square);
    square.x -= by.x * (before.x + moment.x);
    square.y -= by.y * (before.y + moment.y);
    square.z -= by.z * (before.z + moment.z);
    Three<Vector> mixed;
    load_three(body.mixed, t, mixed);
    mixed.x -= by.y * before.z + by.z * moment.y;
    mixed.y -= by.z * before.x + by.x * moment.z;
    mixed.z -= by.x * before.y + by.y * moment.x;
    store_three(moment, t, moved.moment);
    store_three(square, t, moved.square);
    store_three(mixed, t, moved.mixed);
  }
  return t;
}

}  // namespace

void CompositeBody::add(double weight, const ThreeColumns& places, const ThreeColumns& origin,
                        int frames) {
  mass += weight;
  int t = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    t = add_points<Doubles4>(*this, weight, places, origin, 0, frames);
  });
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

CompositeBody CompositeBody::seen_from(const ThreeColumns& place, const ThreeColumns& origin,
                                       int frames) const {
  CompositeBody moved;
  moved.mass = mass;
  int t = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    t = move_origin<Doubles4>(*this, place, origin, 0, frames, moved);
  });
  t = move_origin<Doubles2>(*this, place, origin, t, frames, moved);
  move_origin<Doubles1>(*this, place, origin, t, frames, moved);
  return moved;
}

}  // namespace mocapress
