// SPDX-License-Identifier: MIT
#include "core/codec/encode/closed_loop/bound_kernels.h"

#include <algorithm>
#include <array>

#include "core/base/instruction_sets.h"
#include "core/select/three.h"

namespace mocapress {
namespace {

template <typename Number, typename Vector>
MOCAPRESS_INLINE void load_three(Columns3<Number> from, Eigen::Index frame, Three<Vector>& three) {
  load(from.x + frame, three.x);
  load(from.x + from.stride + frame, three.y);
  load(from.x + 2 * from.stride + frame, three.z);
}

template <typename Vector>
MOCAPRESS_INLINE void store_three(const Three<Vector>& three, Eigen::Index frame,
                                  Columns3<double> to) {
  store(three.x, to.x + frame);
  store(three.y, to.x + to.stride + frame);
  store(three.z, to.x + 2 * to.stride + frame);
}

template <typename Vector, bool kTurns>
MOCAPRESS_INLINE void find_error(const MovedFrames& point, const MovingSteps& steps,
                                 Eigen::Index frame, Three<Vector>& error) {
  Vector step;
  Three<Vector> way;
  load_three(point.error, frame, error);
  load(steps.along + frame, step);
  load_three(point.along, frame, way);
  add_product(step, way, error);
  if (!kTurns) return;
  load(steps.across + frame, step);
  load_three(point.across, frame, way);
  add_product(step, way, error);
}

/// Checks all frames from `frame` on that fill whole vectors, and returns true at the first group
/// with a frame beyond its bound. Otherwise `frame` becomes the first frame left over.
template <typename Vector, bool kTurns>
MOCAPRESS_INLINE bool any_beyond(const MovedFrames& point, const MovingSteps& steps,
                                 const double* squared_bound, Eigen::Index& frame) {
  constexpr int kSize = kLanes<Vector, double>;
  constexpr Eigen::Index kAtATime = 64;  // frames between two tests of the result
  using Mask = decltype(Vector{} > Vector{});
  while (frame + kSize <= steps.frames) {
    Mask beyond{};
    const Eigen::Index end = std::min(frame + kAtATime, steps.frames - kSize + 1);
    for (; frame < end; frame += kSize) {
      Three<Vector> error;
      Vector then;
      Vector now;
      Vector bound;
      find_error<Vector, kTurns>(point, steps, frame, error);
      dot(error, error, then);
      load(point.squared + frame, now);
      load(squared_bound + frame, bound);
      beyond |= (then > bound) & (then > now);
    }
    std::array<char, sizeof beyond> bytes;
    std::memcpy(bytes.data(), &beyond, sizeof beyond);
    if (std::ranges::any_of(bytes, [](char byte) { return byte != 0; })) return true;
  }
  return false;
}

template <typename Vector, bool kTurns>
MOCAPRESS_INLINE void move_from(const MovedFrames& point, const MovingSteps& steps,
                                Eigen::Index& frame) {
  constexpr int kSize = kLanes<Vector, double>;
  for (; frame + kSize <= steps.frames; frame += kSize) {
    Three<Vector> error;
    Vector squared;
    find_error<Vector, kTurns>(point, steps, frame, error);
    dot(error, error, squared);
    store_three(error, frame, point.error);
    store(squared, point.squared + frame);
    if (!kTurns) continue;
    Vector sine;
    Vector less_cosine;
    Three<Vector> along;
    Three<Vector> across;
    load(steps.along + frame, sine);
    load(steps.across + frame, less_cosine);
    load_three(point.along, frame, along);
    load_three(point.across, frame, across);
    const Vector cosine = 1.0 - less_cosine;
    Three<Vector> turned{along.x * cosine, along.y * cosine, along.z * cosine};
    add_product(sine, across, turned);
    Three<Vector> turned_across{across.x * cosine, across.y * cosine, across.z * cosine};
    const Three<Vector> less{along.x * sine, along.y * sine, along.z * sine};
    subtract(less, turned_across);
    store_three(turned, frame, point.along);
    store_three(turned_across, frame, point.across);
  }
}

template <typename Vector>
MOCAPRESS_INLINE void find_way(Columns3<const double> axis, Columns3<const double> origin,
                               Columns3<const double> original, Eigen::Index frames,
                               const MovedFrames& point, Eigen::Index& frame) {
  constexpr int kSize = kLanes<Vector, double>;
  for (; frame + kSize <= frames; frame += kSize) {
    Three<Vector> about;
    Three<Vector> from;
    Three<Vector> place;
    Three<Vector> way;
    Three<Vector> across;
    load_three(axis, frame, about);
    load_three(original, frame, place);
    load_three(point.error, frame, way);
    add(way, place);
    load_three(origin, frame, from);
    subtract(from, place);
    cross(about, place, way);
    cross(about, way, across);
    store_three(way, frame, point.along);
    store_three(across, frame, point.across);
  }
}

template <bool kTurns>
bool goes_beyond_of(const MovedFrames& point, const MovingSteps& steps,
                    const double* squared_bound) {
  Eigen::Index frame = 0;
  bool found = false;
  with_avx2([&]() MOCAPRESS_INLINED {
    found = any_beyond<Doubles4, kTurns>(point, steps, squared_bound, frame);
  });
  return found || any_beyond<Doubles2, kTurns>(point, steps, squared_bound, frame) ||
         any_beyond<Doubles1, kTurns>(point, steps, squared_bound, frame);
}

template <bool kTurns>
void move_point_of(const MovedFrames& point, const MovingSteps& steps) {
  Eigen::Index frame = 0;
  with_avx2([&]() MOCAPRESS_INLINED { move_from<Doubles4, kTurns>(point, steps, frame); });
  move_from<Doubles2, kTurns>(point, steps, frame);
  move_from<Doubles1, kTurns>(point, steps, frame);
}

}  // namespace

bool goes_beyond(const MovedFrames& point, const MovingSteps& steps, const double* squared_bound) {
  return point.across.x ? goes_beyond_of<true>(point, steps, squared_bound)
                        : goes_beyond_of<false>(point, steps, squared_bound);
}

void move_point(const MovedFrames& point, const MovingSteps& steps) {
  point.across.x ? move_point_of<true>(point, steps) : move_point_of<false>(point, steps);
}

void find_way_of_turn(Columns3<const double> axis, Columns3<const double> origin,
                      Columns3<const double> original, Eigen::Index frames,
                      const MovedFrames& point) {
  Eigen::Index frame = 0;
  with_avx2([&]() MOCAPRESS_INLINED {
    find_way<Doubles4>(axis, origin, original, frames, point, frame);
  });
  find_way<Doubles2>(axis, origin, original, frames, point, frame);
  find_way<Doubles1>(axis, origin, original, frames, point, frame);
}

}  // namespace mocapress
