// SPDX-License-Identifier: MIT
// The work on whole rows, in several instruction sets. A row holds one sample of every signal, so
// that the work across signals is alike and needs no shuffling. Every path does the same operations
// in the same order and without contraction: the bits agree.
#pragma once

#include <cstddef>
#include <cstdint>

namespace mocapress::runtime {

/// Even rows: out = even - (detail_before + detail_after) / 4. All rows are `stride` apart, which
/// is a multiple of 8.
template <typename Real>
struct EvenRows {
  Real* out;
  const Real* even;
  const Real* detail_before;
  const Real* detail_after;
  std::ptrdiff_t stride;
  int rows;
};

/// Odd rows between four even ones: out = detail + (near * (even[1] + even[2]) + far * (even[0] +
/// even[3])).
template <typename Real>
struct OddRows {
  Real* out;           // out_step apart
  const Real* even;    // the first of the four of the first row, stride apart
  const Real* detail;  // detail_step apart: 0 where all are the same row of zeros
  std::ptrdiff_t out_step;
  std::ptrdiff_t stride;
  std::ptrdiff_t detail_step;
  std::ptrdiff_t width;  // floats of a row
  int rows;
  Real near;
  Real far;
};

/// One odd row near a border: out = detail + ((w0 e0 + w1 e1) + (w2 e2 + w3 e3)).
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

/// Rows of packed numbers, each of as many bits as its column's width and 2^(width - 1) too large,
/// to be multiplied by step * gain. 8 by 8 they begin at a byte. Up to 32 bytes after the last are
/// read.
struct PackedRows {
  float* out;                  // stride apart
  const std::byte* packed;     // row_bytes apart
  const std::uint8_t* widths;  // of each number, 0 ... 32
  const float* steps;          // of each number
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

/// For the few signals that floats are too coarse for.
extern const LiftingKernels<double> kWideRows;

extern const RowKernels kPlainRows;

#if defined(__x86_64__) && defined(__GNUC__)
#define MOCAPRESS_DECODER_AVX2
extern const RowKernels kAvx2Rows;  // where the machine has AVX2
#endif

/// Null where the build or the machine has none.
const RowKernels* sse2_rows();
const RowKernels* avx2_rows();

/// The fastest that there is.
const RowKernels& best_rows();

/// PackedRows::unpack without vectors, of the groups from `first_group` to before `end_group`.
/// Returns where the next group of the first row begins.
const std::byte* unpack_plainly(const PackedRows& rows, int first_group, int end_group,
                                const std::byte* packed);

}  // namespace mocapress::runtime
