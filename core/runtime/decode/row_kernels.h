// SPDX-License-Identifier: MIT
// Operations on whole rows, for several instruction sets. A row holds one sample of every signal,
// so that vector operations need no shuffling. All instruction sets give the same bits: they
// perform the same operations in the same order, without contraction to fused multiply-adds.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/mocapress_runtime.h"

namespace mocapress::runtime {

/// Updates even rows: out = even - (detail_before + detail_after) / 4. Rows are `stride` apart, a
/// multiple of 8.
template <typename Real>
struct EvenRows {
  Real* out;
  const Real* even;
  const Real* detail_before;
  const Real* detail_after;
  std::ptrdiff_t stride;
  int rows;
};

/// Predicts odd rows between four even ones: out = detail + (near * (even[1] + even[2]) + far *
/// (even[0] + even[3])).
template <typename Real>
struct OddRows {
  Real* out;         // rows are out_step apart
  const Real* even;  // first of the four even rows around the first odd row; rows are stride apart
  const Real* detail;  // rows are detail_step apart; with a detail_step of 0, all rows use the same
                       // one
  std::ptrdiff_t out_step;
  std::ptrdiff_t stride;
  std::ptrdiff_t detail_step;
  std::ptrdiff_t width;  // floats per row
  int rows;
  Real near;
  Real far;
};

/// Predicts one odd row near a border: out = detail + ((w0 e0 + w1 e1) + (w2 e2 + w3 e3)).
template <typename Real>
struct BorderRow {
  Real* out;
  const Real* even[4];
  Real weight[4];
  const Real* detail;
  std::ptrdiff_t width;
};

template <typename Real>
struct CopiedRows {
  Real* out;
  const Real* from;
  std::ptrdiff_t out_step;
  std::ptrdiff_t stride;
  std::ptrdiff_t width;
  int rows;
};

/// Rows of packed numbers, to be unpacked and multiplied by step * gain. A number takes as many
/// bits as its column's width, and is stored with a bias of 2^(width - 1). Every group of 8 numbers
/// starts at a byte. The kernels may read up to 32 bytes after the last group.
struct PackedRows {
  float* out;                  // rows are stride apart
  const std::byte* packed;     // rows are row_bytes apart
  const std::uint8_t* widths;  // bits of each number, 0 ... 32
  const float* steps;          // step of each number
  std::ptrdiff_t stride;
  std::ptrdiff_t row_bytes;
  int groups;
  int rows;
  float gain;
};

template <typename Real>
struct LiftingKernels {
  void (*update)(const EvenRows<Real>&);
  void (*predict)(const OddRows<Real>&);
  void (*predict_at_border)(const BorderRow<Real>&);
  void (*copy)(const CopiedRows<Real>&);
};

struct RowKernels {
  LiftingKernels<float> lifting;
  void (*unpack)(const PackedRows&);
};

/// Kernels for signals decoded in double precision.
extern const LiftingKernels<double> kWideRows;

extern const RowKernels kPlainRows;

extern const RowKernels kAvx2Rows;  // only in a build with AVX2

/// The kernels of a path; null if the build or the machine does not have it.
const RowKernels* rows_of(mcpr_path path);

/// The fastest kernels available.
inline const RowKernels& best_rows() {
  return *rows_of(MCPR_PATH_BEST);
}

/// Unpacks groups first_group ... end_group - 1 of all rows, without vector instructions. `packed`
/// is the start of these groups in the first row; returns their end in that row.
const std::byte* unpack_plainly(const PackedRows& rows, int first_group, int end_group,
                                const std::byte* packed);

}  // namespace mocapress::runtime
