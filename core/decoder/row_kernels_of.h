// SPDX-License-Identifier: MIT
// The kernels of row_kernels.h for one type of vector: some floats with +, - and * by element,
// load(), store() and all(). Each file that includes this compiles them for its own instructions.
#pragma once

#include "row_kernels.h"

namespace mocapress::decoder {
namespace {

struct PlainVector {
  static constexpr std::ptrdiff_t kSize = 1;
  float value;

  static PlainVector load(const float* from) { return {*from}; }
  static PlainVector all(float value) { return {value}; }
  void store(float* to) const { *to = value; }
};

inline PlainVector operator+(PlainVector a, PlainVector b) {
  return {a.value + b.value};
}
inline PlainVector operator-(PlainVector a, PlainVector b) {
  return {a.value - b.value};
}
inline PlainVector operator*(PlainVector a, PlainVector b) {
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
  for (; k < width; ++k) step.template at<PlainVector>(k);
}

template <typename V>
void update_rows(const EvenRows& rows) {
  const V quarter = V::all(0.25F);
  const std::ptrdiff_t count = rows.rows * rows.stride;
  for (std::ptrdiff_t k = 0; k < count; k += V::kSize) {
    const V details = V::load(rows.detail_before + k) + V::load(rows.detail_after + k);
    (V::load(rows.even + k) - quarter * details).store(rows.out + k);
  }
}

struct PredictStep {
  // Copies: what is stored might be taken for an alias of what a reference refers to.
  float* out;
  const float* even;
  const float* detail;
  std::ptrdiff_t stride;
  float near;
  float far;

  template <typename V>
  void at(std::ptrdiff_t k) const {
    const float* const e = even + k;
    const V nearest = V::load(e + stride) + V::load(e + 2 * stride);
    const V others = V::load(e) + V::load(e + 3 * stride);
    const V predicted = V::all(near) * nearest + V::all(far) * others;
    (V::load(detail + k) + predicted).store(out + k);
  }
};

template <typename V>
void predict_rows(const OddRows& rows) {
  for (int r = 0; r < rows.rows; ++r)
    across<V>(rows.width,
              PredictStep{rows.out + r * rows.out_step, rows.even + r * rows.stride,
                          rows.detail + r * rows.detail_step, rows.stride, rows.near, rows.far});
}

struct BorderStep {
  const BorderRow& row;

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
void predict_border_row(const BorderRow& row) {
  across<V>(row.width, BorderStep{row});
}

struct CopyStep {
  float* out;
  const float* from;

  template <typename V>
  void at(std::ptrdiff_t k) const {
    V::load(from + k).store(out + k);
  }
};

template <typename V>
void copy_rows(const CopiedRows& rows) {
  for (int r = 0; r < rows.rows; ++r)
    across<V>(rows.width, CopyStep{rows.out + r * rows.out_step, rows.from + r * rows.stride});
}

}  // namespace
}  // namespace mocapress::decoder
