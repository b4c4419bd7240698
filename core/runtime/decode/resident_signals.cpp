// SPDX-License-Identifier: MIT
#include "core/runtime/decode/resident_signals.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "core/runtime/format/bits.h"

namespace mocapress::runtime {

/// The factor from the signals' steps to the quantisation steps of this band: 2^(-depth / 2).
template <typename Real>
Real ResidentSignals::gain(int band) const {
  constexpr Real kRootOfHalf = static_cast<Real>(0x1.6a09e667f3bcdp-1);
  const int depth = band_count_ == 1 ? 0 : band_count_ - std::max(band, 1);
  const Real whole = Real{1} / static_cast<Real>(std::uint64_t{1} << (depth / 2));
  return depth % 2 == 0 ? whole : whole * kRootOfHalf;
}

int ResidentSignals::listed_signal(const BandEntry& entry, std::uint32_t i) const {
  if (has_wide_numbers()) {
    std::uint16_t signal;
    std::memcpy(&signal, at<std::byte>(entry.list_offset) + 2 * i, sizeof signal);
    return signal;
  }
  return at<std::uint8_t>(entry.list_offset)[i];
}

template <typename Real>
void ResidentSignals::unpack(int band, int first, int end, const Columns& columns,
                             Real* rows) const {
  if (first >= end) return;
  if constexpr (std::is_same_v<Real, float>)
    if (entries()[band].kind == Kind::Dense && columns.in_order)
      return unpack_rows(band, first, end, columns, rows);
  std::fill_n(rows, (end - first) * columns.stride, Real{0});
  if (entries()[band].kind == Kind::Dense)
    unpack_chosen(band, first, end, columns, rows);
  else
    unpack_sparse(band, first, end, columns, rows);
}

template void ResidentSignals::unpack(int, int, int, const Columns&, float*) const;
template void ResidentSignals::unpack(int, int, int, const Columns&, double*) const;

/// Unpacks all signals of a dense band, in groups of 8.
void ResidentSignals::unpack_rows(int band, int first, int end, const Columns& columns,
                                  float* rows) const {
  const BandEntry& entry = entries()[band];
  const auto groups = static_cast<int>(columns.stride / 8);
  columns.kernels->unpack({.out = rows,
                           .packed = at<std::byte>(entry.bits_offset) +
                                     static_cast<std::ptrdiff_t>(first) * entry.present,
                           .widths = at<std::uint8_t>(entry.offset),
                           .steps = steps(),
                           .stride = columns.stride,
                           .row_bytes = static_cast<std::ptrdiff_t>(entry.present),
                           .groups = groups < group_count() ? groups : group_count(),
                           .rows = end - first,
                           .gain = gain<float>(band)});
}

/// Unpacks only the signals that have a column, one by one.
template <typename Real>
void ResidentSignals::unpack_chosen(int band, int first, int end, const Columns& columns,
                                    Real* rows) const {
  const BandEntry& entry = entries()[band];
  const std::byte* const packed =
      at<std::byte>(entry.bits_offset) + static_cast<std::ptrdiff_t>(first) * entry.present;
  const auto* const widths = at<std::uint8_t>(entry.offset);
  const Real gain_of_band = gain<Real>(band);
  std::uint64_t bit = 0;
  for (int s = 0; s < signals_; ++s) {
    if (s % 8 == 0) bit = (bit + 7) / 8 * 8;
    const int width = widths[s];
    const std::int32_t column = columns.of_signal[s];
    const Real step = static_cast<Real>(steps()[s]) * gain_of_band;
    const std::uint64_t mask = (std::uint64_t{1} << width) - 1;
    const auto bias = static_cast<std::int64_t>((mask + 1) >> 1 & mask);
    for (int r = 0; r < end - first && column != Columns::kNone; ++r) {
      const auto bits =
          bits_at(packed + static_cast<std::ptrdiff_t>(r) * entry.present, bit) & mask;
      const auto value = static_cast<std::int32_t>(static_cast<std::int64_t>(bits) - bias);
      rows[r * columns.stride + column] = static_cast<Real>(value) * step;
    }
    bit += static_cast<std::uint64_t>(width);
  }
}

template <typename Real>
void ResidentSignals::unpack_sparse(int band, int first, int end, const Columns& columns,
                                    Real* rows) const {
  const int log2_rows = entries()[band].log2_rows;
  for (int block = first >> log2_rows; block <= (end - 1) >> log2_rows; ++block)
    unpack_block(band, block, first, end, columns, rows);
}

template <typename Real>
void ResidentSignals::unpack_block(int band, int block, int first, int end, const Columns& columns,
                                   Real* rows) const {
  const BandEntry& entry = entries()[band];
  const Real gain_of_band = gain<Real>(band);
  std::uint32_t offset = 0;
  const std::size_t offset_size = entry.kind == Kind::SparseWide ? 4 : 2;
  std::memcpy(&offset, at<std::byte>(entry.offset) + offset_size * static_cast<std::size_t>(block),
              offset_size);
  BitReader reader(at<std::byte>(entry.bits_offset) + offset);
  const std::uint32_t row_mask = (std::uint32_t{1} << entry.log2_rows) - 1;
  const int first_row = (block << entry.log2_rows) - first;
  const auto row_count = static_cast<std::uint32_t>(end - first);
  std::uint32_t place = 0;
  for (std::uint32_t left = reader.rice(kCountShift); left > 0; --left, ++place) {
    place += reader.rice(entry.gap_shift);
    const std::uint32_t magnitude = reader.rice(entry.value_shift) + 1;
    const bool minus = reader.flag();
    const auto row = static_cast<std::uint32_t>(first_row + static_cast<int>(place & row_mask));
    // `row` is unsigned: rows before `first` become large numbers.
    if (row >= row_count) continue;
    const int signal = listed_signal(entry, place >> entry.log2_rows);
    const std::int32_t column = columns.of_signal[signal];
    if (column == Columns::kNone) continue;
    const auto value = static_cast<std::int32_t>(minus ? 0U - magnitude : magnitude);
    rows[static_cast<std::ptrdiff_t>(row) * columns.stride + column] =
        static_cast<Real>(value) * (static_cast<Real>(steps()[signal]) * gain_of_band);
  }
}

}  // namespace mocapress::runtime
