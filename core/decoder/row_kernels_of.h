// SPDX-License-Identifier: MIT
// The kernels of row_kernels.h for one type of vector: some floats with +, - and * by element,
// load(), store() and all(). Each file that includes this compiles them for its own instructions.
#pragma once

#include "row_kernels.h"

namespace mocapress::decoder {
namespace {

template <typename V>
void update_rows(const EvenRows& rows) {
  const V quarter = V::all(0.25F);
  for (int r = 0; r < rows.rows; ++r) {
    const std::ptrdiff_t at = r * rows.stride;
    float* const out = rows.out + 2 * at;
    const float* const even = rows.even + at;
    const float* const before = rows.detail_before + at;
    const float* const after = rows.detail_after + at;
    for (std::ptrdiff_t k = 0; k < rows.stride; k += V::kSize)
      (V::load(even + k) - quarter * (V::load(before + k) + V::load(after + k))).store(out + k);
  }
}

template <typename V>
void predict_rows(const OddRows& rows) {
  const V near = V::all(rows.near);
  const V far = V::all(rows.far);
  const std::ptrdiff_t step = 2 * rows.stride;
  for (int r = 0; r < rows.rows; ++r) {
    float* const out = rows.out + r * step;
    const float* const even = rows.even + r * step;
    const float* const detail = rows.detail + r * rows.detail_stride;
    for (std::ptrdiff_t k = 0; k < rows.stride; k += V::kSize) {
      const float* const e = even + k;
      const V nearest = V::load(e + step) + V::load(e + 2 * step);
      const V others = V::load(e) + V::load(e + 3 * step);
      (V::load(detail + k) + (near * nearest + far * others)).store(out + k);
    }
  }
}

template <typename V>
void predict_border_row(const BorderRow& row) {
  for (std::ptrdiff_t k = 0; k < row.stride; k += V::kSize) {
    const auto term = [&](int i) { return V::all(row.weight[i]) * V::load(row.even[i] + k); };
    (V::load(row.detail + k) + ((term(0) + term(1)) + (term(2) + term(3)))).store(row.out + k);
  }
}

template <typename V>
constexpr RowKernels kernels_of() {
  return {update_rows<V>, predict_rows<V>, predict_border_row<V>};
}

}  // namespace
}  // namespace mocapress::decoder
