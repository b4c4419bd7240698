// SPDX-License-Identifier: MIT
// The two steps of the inverse lifting on whole rows, in several instruction sets. A row holds one
// sample of every signal, so that the work across signals is alike and needs no shuffling. Every
// path does the same operations in the same order and without contraction: the bits agree.
#pragma once

#include <cstddef>

namespace mocapress::decoder {

/// Even rows: out = even - (detail_before + detail_after) / 4. `out` rows are 2 * stride apart, all
/// others `stride`, which is a multiple of 8.
struct EvenRows {
  float* out;
  const float* even;
  const float* detail_before;
  const float* detail_after;
  std::ptrdiff_t stride;
  int rows;
};

/// Odd rows between four even ones: out = detail + (near * (even[1] + even[2]) + far * (even[0] +
/// even[3])). `out` and `even` rows are 2 * stride apart.
struct OddRows {
  float* out;
  const float* even;    // the first of the four of the first row
  const float* detail;  // detail_stride apart: 0 where all are the same row of zeros
  std::ptrdiff_t stride;
  std::ptrdiff_t detail_stride;
  int rows;
  float near;
  float far;
};

/// One odd row near a border: out = detail + ((w0 e0 + w1 e1) + (w2 e2 + w3 e3)).
struct BorderRow {
  float* out;
  const float* even[4];
  float weight[4];
  const float* detail;
  std::ptrdiff_t stride;
};

struct RowKernels {
  void (*update)(const EvenRows&);
  void (*predict)(const OddRows&);
  void (*predict_at_border)(const BorderRow&);
};

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

}  // namespace mocapress::decoder
