// SPDX-License-Identifier: MIT
#include "core/select/inner_product.h"

#include "core/base/instruction_sets.h"

namespace mocapress {
namespace {

constexpr int kAtATime = 8;

/// Partial sums over every eighth product, in the order of vector instructions.
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

}  // namespace

float inner_product(const float* a, const float* b, Eigen::Index count) {
  float sum = 0;
  if (!with_avx2([&]() MOCAPRESS_INLINED { sum = inner_product_of<Floats8>(a, b, count); }))
    sum = inner_product_of<Floats4>(a, b, count);
  return sum;
}

}  // namespace mocapress
