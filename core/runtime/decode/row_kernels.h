// SPDX-License-Identifier: MIT
// Operations on whole rows, for several instruction sets. A row holds one sample of every signal,
// so that vector operations need no shuffling. Every path performs the same operations in the same
// order and without contraction, so that all give the same bits.
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
  Real* out;           // rows are out_step apart
  const Real* even;    // first of the four neighbours of the first row; rows are stride apart
  const Real* detail;  // rows are detail_step apart; 0 repeats one row of zeros
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

/// Rows of packed numbers to be multiplied by step * gain. Each number is stored in its column's
/// width, with a bias of 2^(width - 1). Every group of 8 begins at a byte. Up to 32 bytes after the
/// last one are read.
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

extern const RowKernels kAvx2Rows;  // if the build has AVX2

/// Null if the build or the machine does not have the path.
const RowKernels* rows_of(mcpr_path path);

/// The fastest kernels available.
inline const RowKernels& best_rows() {
  return *rows_of(MCPR_PATH_BEST);
}

/// Unpacks groups first_group ... end_group - 1 without vector instructions. Returns the position
/// of the next group of the first row.
const std::byte* unpack_plainly(const PackedRows& rows, int first_group, int end_group,
                                const std::byte* packed);

}  // namespace mocapress::runtime
