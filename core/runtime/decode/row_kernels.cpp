// SPDX-License-Identifier: MIT
#include "core/runtime/decode/row_kernels.h"

#include "core/runtime/format/bits.h"
#include "core/runtime/processor/path.h"

#define MOCAPRESS_ROWS base_rows
#define MOCAPRESS_ROWS_TARGET
#include "core/runtime/decode/row_kernels_of.inc"

namespace mocapress::runtime {
namespace {

void unpack_all_plainly(const PackedRows& rows) {
  unpack_plainly(rows, 0, rows.groups, rows.packed);
}

#ifdef MOCAPRESS_FOUR
const RowKernels kFourRows = {base_rows::lifting_of<Floats4>(), unpack_all_plainly};
#endif

}  // namespace

const std::byte* unpack_plainly(const PackedRows& rows, int first_group, int end_group,
                                const std::byte* packed) {
  for (int g = first_group; g < end_group; ++g) {
    std::uint64_t bit = 0;
    for (int column = 8 * g; column < 8 * g + 8; ++column) {
      const int width = rows.widths[column];
      const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
      const auto bias = static_cast<std::int64_t>((mask + 1) >> 1 & mask);
      const float step = rows.steps[column] * rows.gain;
      for (int r = 0; r < rows.rows; ++r) {
        const std::uint64_t bits = bits_at(packed + r * rows.row_bytes, bit) & mask;
        const auto value = static_cast<std::int32_t>(static_cast<std::int64_t>(bits) - bias);
        rows.out[r * rows.stride + column] = static_cast<float>(value) * step;
      }
      bit += static_cast<std::uint64_t>(width);
    }
    packed += (bit + 7) / 8;
  }
  return packed;
}

const RowKernels kPlainRows = {base_rows::lifting_of<base_rows::PlainVectorOf<float>>(),
                               unpack_all_plainly};
const LiftingKernels<double> kWideRows = base_rows::lifting_of<base_rows::PlainVectorOf<double>>();

const RowKernels* rows_of(mcpr_path path) {
  switch (kernels_of(path)) {
    case Kernels::None:
      break;
    case Kernels::Plain:
      return &kPlainRows;
    case Kernels::Four:
#ifdef MOCAPRESS_FOUR
      return &kFourRows;
#else
      break;
#endif
    case Kernels::Avx2:
#ifdef MOCAPRESS_HAS_AVX2
      return &kAvx2Rows;
#else
      break;
#endif
  }
  return nullptr;
}

}  // namespace mocapress::runtime
