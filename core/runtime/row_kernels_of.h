// SPDX-License-Identifier: MIT
// The kernels of row_kernels.h for one type of vector: some reals with +, - and * by element,
// load(), store() and all(). Each file that includes this compiles them for its own instructions.
#pragma once

#include "core/runtime/row_kernels.h"

namespace mocapress::runtime {
namespace {

template <typename Element>
struct PlainVectorOf {
  using Real = Element;
  static constexpr std::ptrdiff_t kSize = 1;
  Real value;

  static PlainVectorOf load(const Real* from) { return {*from}; }
  static PlainVectorOf all(Real value) { return {value}; }
  void store(Real* to) const { *to = value; }
};

template <typename Real>
PlainVectorOf<Real> operator+(PlainVectorOf<Real> a, PlainVectorOf<Real> b) {
  return {a.value + b.value};
}
template <typename Real>
PlainVectorOf<Real> operator-(PlainVectorOf<Real> a, PlainVectorOf<Real> b) {
  return {a.value - b.value};
}
template <typename Real>
PlainVectorOf<Real> operator*(PlainVectorOf<Real> a, PlainVectorOf<Real> b) {
  return {a.value * b.value};
}

/// Calls step.template at<Vector>(k) for vectors that make up a row. The last one overlaps the one
/// before it where the row is no multiple of a vector: what is computed twice is the same twice.
template <typename V, typename Step>
inline void across(std::ptrdiff_t width, const Step& step) {
  std::ptrdiff_t k = 0;
  for (; k + V::kSize <= width; k += V::kSize) step.template at<V>(k);
  if (k == width) return;
  if (width >= V::kSize) return step.template at<V>(width - V::kSize);
  for (; k < width; ++k) step.template at<PlainVectorOf<typename V::Real>>(k);
}

template <typename V>
void update_rows(const EvenRows<typename V::Real>& rows) {
  const V quarter = V::all(typename V::Real{0.25});
  const std::ptrdiff_t count = rows.rows * rows.stride;
  for (std::ptrdiff_t k = 0; k < count; k += V::kSize) {
    const V details = V::load(rows.detail_before + k) + V::load(rows.detail_after + k);
    (V::load(rows.even + k) - quarter * details).store(rows.out + k);
  }
}

template <typename Real>
struct PredictStep {
  // Copies: what is stored might be taken for an alias of what a reference refers to.
  Real* out;
  const Real* even;
  const Real* detail;
  std::ptrdiff_t stride;
  Real near;
  Real far;

  template <typename V>
  void at(std::ptrdiff_t k) const {
    const Real* const e = even + k;
    const V nearest = V::load(e + stride) + V::load(e + 2 * stride);
    const V others = V::load(e) + V::load(e + 3 * stride);
    const V predicted = V::all(near) * nearest + V::all(far) * others;
    (V::load(detail + k) + predicted).store(out + k);
  }
};

template <typename V>
void predict_rows(const OddRows<typename V::Real>& rows) {
  for (int r = 0; r < rows.rows; ++r)
    across<V>(rows.width, PredictStep<typename V::Real>{rows.out + r * rows.out_step,
                                                        rows.even + r * rows.stride,
                                                        rows.detail + r * rows.detail_step,
                                                        rows.stride, rows.near, rows.far});
}

template <typename Real>
struct BorderStep {
  const BorderRow<Real>& row;

  template <typename V>
  void at(std::ptrdiff_t k) const {
    const V first = V::all(row.weight[0]) * V::load(row.even[0] + k) +
                    V::all(row.weight[1]) * V::load(row.even[1] + k);
    const V last = V::all(row.weight[2]) * V::load(row.even[2] + k) +
                   V::all(row.weight[3]) * V::load(row.even[3] + k);
    (V::load(row.detail + k) + (first + last)).store(row.out + k);
  }
};

template <typename V>
void predict_border_row(const BorderRow<typename V::Real>& row) {
  across<V>(row.width, BorderStep<typename V::Real>{row});
}

template <typename Real>
struct CopyStep {
  Real* out;
  const Real* from;

  template <typename V>
  void at(std::ptrdiff_t k) const {
    V::load(from + k).store(out + k);
  }
};

template <typename V>
void copy_rows(const CopiedRows<typename V::Real>& rows) {
  for (int r = 0; r < rows.rows; ++r)
    across<V>(rows.width, CopyStep<typename V::Real>{rows.out + r * rows.out_step,
                                                     rows.from + r * rows.stride});
}

template <typename V>
constexpr LiftingKernels<typename V::Real> lifting_of() {
  return {update_rows<V>, predict_rows<V>, predict_border_row<V>, copy_rows<V>};
}

}  // namespace
}  // namespace mocapress::runtime
