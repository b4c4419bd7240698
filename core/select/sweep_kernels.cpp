// SPDX-License-Identifier: MIT
#include "core/select/sweep_kernels.h"

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

constexpr int kAtATime = 8;

/// The sum of six products from frame t on.
template <typename Vector>
MOCAPRESS_INLINE void dot(const SixColumns& a, const SixColumns& b, Eigen::Index t, Vector& sum) {
  Vector x;
  Vector y;
  load(a[0] + t, x);
  load(b[0] + t, y);
  sum = x * y;
  for (Eigen::Index i = 1; i < 6; ++i) {
    load(a[i] + t, x);
    load(b[i] + t, y);
    sum += x * y;
  }
}

/// As many frames as make up vectors; returns the first that is left over.
template <typename Vector>
MOCAPRESS_INLINE Eigen::Index find_work_of(const SixColumns& force, const SixColumns& motion,
                                           const SixColumns& other_force,
                                           const SixColumns& other_motion, Eigen::Index t,
                                           Eigen::Index frames, float* out) {
  for (; t + kLanes<Vector, float> <= frames; t += kLanes<Vector, float>) {
    Vector one;
    Vector other;
    dot(force, motion, t, one);
    dot(other_force, other_motion, t, other);
    store<Vector>(one + other, out + t);
  }
  return t;
}

template <typename Vector>
MOCAPRESS_INLINE Eigen::Index add_work_of(const SixColumns& force, const SixColumns& motion,
                                          const float* factors, Eigen::Index t, Eigen::Index frames,
                                          float* sums) {
  for (; t + kLanes<Vector, float> <= frames; t += kLanes<Vector, float>) {
    Vector work;
    Vector factor;
    Vector sum;
    dot(force, motion, t, work);
    load(factors + t, factor);
    load(sums + t, sum);
    store<Vector>(sum + factor * work, sums + t);
  }
  return t;
}

/// Sums of every eighth product, as the vectors have it.
template <typename Vector>
MOCAPRESS_INLINE float inner_product_of(const float* a, const float* b, Eigen::Index count) {
  constexpr int kVectors = kAtATime / kLanes<Vector, float>;
  Vector sums[kVectors] = {};
  for (Eigen::Index i = 0; i < count; i += kAtATime)
    for (int v = 0; v < kVectors; ++v) {
      Vector x;
      Vector y;
      load(a + i + v * kLanes<Vector, float>, x);
      load(b + i + v * kLanes<Vector, float>, y);
      sums[v] += x * y;
    }
  float parts[kAtATime];
  for (int v = 0; v < kVectors; ++v) store(sums[v], parts + v * kLanes<Vector, float>);
  return ((parts[0] + parts[4]) + (parts[2] + parts[6])) +
         ((parts[1] + parts[5]) + (parts[3] + parts[7]));
}

template <typename Vector, int count>
MOCAPRESS_INLINE Eigen::Index add_products_of(const AddedProducts& columns, Eigen::Index t,
                                              Eigen::Index frames, float* sum) {
  for (; t + kLanes<Vector, float> <= frames; t += kLanes<Vector, float>) {
    Vector products;
    Vector unit;
    Vector factor;
    load(columns.units[0] + t, unit);
    load(columns.factors[0] + t, factor);
    products = unit * factor;
    for (int i = 1; i < count; ++i) {
      load(columns.units[i] + t, unit);
      load(columns.factors[i] + t, factor);
      products += unit * factor;
    }
    Vector before;
    load(columns.before + t, before);
    store<Vector>(before + products, sum + t);
  }
  return t;
}

template <typename Vector>
MOCAPRESS_INLINE Eigen::Index add_products_of(const AddedProducts& columns, int count,
                                              Eigen::Index t, Eigen::Index frames, float* sum) {
  if (count == 1) return add_products_of<Vector, 1>(columns, t, frames, sum);
  if (count == 2) return add_products_of<Vector, 2>(columns, t, frames, sum);
  return add_products_of<Vector, 3>(columns, t, frames, sum);
}

#ifdef MOCAPRESS_WITH_AVX2
MOCAPRESS_FOR_AVX2 Eigen::Index find_work_with_avx2(const SixColumns& force,
                                                    const SixColumns& motion,
                                                    const SixColumns& other_force,
                                                    const SixColumns& other_motion,
                                                    Eigen::Index frames, float* out) {
  return find_work_of<Floats8>(force, motion, other_force, other_motion, 0, frames, out);
}
MOCAPRESS_FOR_AVX2 Eigen::Index add_work_with_avx2(const SixColumns& force,
                                                   const SixColumns& motion, const float* factors,
                                                   Eigen::Index frames, float* sum) {
  return add_work_of<Floats8>(force, motion, factors, 0, frames, sum);
}
MOCAPRESS_FOR_AVX2 float inner_product_with_avx2(const float* a, const float* b,
                                                 Eigen::Index count) {
  return inner_product_of<Floats8>(a, b, count);
}
MOCAPRESS_FOR_AVX2 Eigen::Index add_products_with_avx2(const AddedProducts& columns, int count,
                                                       Eigen::Index frames, float* sum) {
  return add_products_of<Floats8>(columns, count, 0, frames, sum);
}
#endif

}  // namespace

void find_work(SixColumns force, SixColumns motion, SixColumns other_force, SixColumns other_motion,
               Eigen::Index frames, float* out) {
  Eigen::Index t = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) t = find_work_with_avx2(force, motion, other_force, other_motion, frames, out);
#endif
  t = find_work_of<Floats4>(force, motion, other_force, other_motion, t, frames, out);
  find_work_of<Floats1>(force, motion, other_force, other_motion, t, frames, out);
}

void add_work(SixColumns force, SixColumns motion, const float* factors, Eigen::Index frames,
              float* sum) {
  Eigen::Index t = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) t = add_work_with_avx2(force, motion, factors, frames, sum);
#endif
  t = add_work_of<Floats4>(force, motion, factors, t, frames, sum);
  add_work_of<Floats1>(force, motion, factors, t, frames, sum);
}

float inner_product(const float* a, const float* b, Eigen::Index count) {
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) return inner_product_with_avx2(a, b, count);
#endif
  return inner_product_of<Floats4>(a, b, count);
}

void add_products(const AddedProducts& columns, int count, Eigen::Index frames, float* sum) {
  Eigen::Index t = 0;
#ifdef MOCAPRESS_WITH_AVX2
  if (has_avx2()) t = add_products_with_avx2(columns, count, frames, sum);
#endif
  t = add_products_of<Floats4>(columns, count, t, frames, sum);
  add_products_of<Floats1>(columns, count, t, frames, sum);
}

}  // namespace mocapress
