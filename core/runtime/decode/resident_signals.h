// SPDX-License-Identifier: MIT
// The motion as an engine keeps it: sparse quantised coefficients, ordered by band and time, from
// which any rows of any band unpack by themselves.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/bands.h"
#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

/// Quantised coefficients: what a resident form is made of.
struct QuantisedSource {
  int length;  // coefficients of each signal, coarse to fine
  int signal_count;
  Wavelet wavelet;
  const float* steps;  // of each signal, before they are divided by bands
  /// Of each signal: one with larger samples is decoded in double precision.
  const float* double_precision_limits;
  const std::int32_t* values;  // signal after signal
  std::uint8_t* notes;         // a byte for each signal, to work in
  std::uint64_t budget_bytes;  // for the bands; beyond, each takes its smaller kind
};

/// What the work of decoding signals depends on.
struct SignalsShape {
  int length = 0;
  int signal_count = 0;
  int double_precision_count = 0;  // of the signals that are decoded in double precision
};

/// The resident form. It has no pointers; everything is found by offsets in bytes from `this`.
///
/// A band is dense, sparse or empty. Dense: row after row, every coefficient in the bits that its
/// signal needs in this band. Sparse: blocks of 2^k rows, and of each signal what is not zero
/// there, with the gap to the one before. The smaller of the two is taken; but coarse bands are
/// dense, which is faster, as far as the budget goes.
class ResidentSignals {
 public:
  /// How many bytes build() makes.
  static std::uint64_t size(const QuantisedSource& source);

  /// Builds at `memory`, which is zeroed and aligned for it.
  static const ResidentSignals* build(const QuantisedSource& source, std::byte* memory);

  /// Whether a form from anywhere, of which there are so many bytes, is of that length and count
  /// and can be decoded without looking beyond them. It is aligned, and its head is there.
  bool is_sound(std::uint64_t bytes, std::uint32_t length, std::uint32_t signals) const;

  int length() const { return length_; }
  int signal_count() const { return signals_; }
  Wavelet wavelet() const { return wavelet_; }
  int band_count() const { return band_count_; }
  SignalsShape shape() const { return {length_, signals_, double_precision_count_}; }

  /// Signals that are to be decoded in double precision.
  int double_precision_count() const { return double_precision_count_; }
  const std::uint16_t* double_precision_signals() const { return at<std::uint16_t>(wide_); }

  float step(int signal) const { return steps()[signal]; }  // before it is divided by bands

  bool is_empty(int band) const { return entries()[band].kind == Kind::Empty; }

  /// Where the values of unpack() go.
  struct Columns {
    const std::int32_t* of_signal;  // column of each; kNone: left out
    bool in_order;                  // signal s in column s, as many as there are columns
    std::ptrdiff_t stride;          // of rows, a multiple of 8
    const RowKernels* kernels;
    static constexpr std::int32_t kNone = -1;
  };

  /// Rows first ... end - 1 of a band, which is not empty, times their steps: each a row of
  /// `columns.stride` floats, of no meaning where there is no column.
  template <typename Real>
  void unpack(int band, int first, int end, const Columns& columns, Real* rows) const;

 private:
  static constexpr int kCountShift = 3;  // of the Rice code of a block's count
  enum class Kind : std::uint8_t { Empty, Dense, Sparse, SparseWide };  // wide offsets of blocks
  friend class ResidentBuilder;
  friend class ResidentChecker;

  struct BandEntry {
    Kind kind = Kind::Empty;
    std::uint8_t log2_rows = 0;  // of a block
    std::uint8_t gap_shift = 0;  // of Rice codes
    std::uint8_t value_shift = 0;
    std::uint32_t present = 0;      // sparse: signals that occur. dense: bits of a row
    std::uint32_t offset = 0;       // dense: widths. sparse: offsets of blocks
    std::uint32_t list_offset = 0;  // sparse: the signals that occur
    std::uint32_t bits_offset = 0;
  };

  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
  const float* steps() const { return at<float>(steps_); }  // of each signal, zeros to a full group
  int group_count() const { return (signals_ + 7) / 8; }
  const BandEntry* entries() const { return at<BandEntry>(entries_); }
  bool has_wide_numbers() const { return signals_ > 256; }
  int listed_signal(const BandEntry& entry, std::uint32_t i) const;
  template <typename Real>
  Real gain(int band) const;
  void unpack_rows(int band, int first, int end, const Columns& columns, float* rows) const;
  template <typename Real>
  void unpack_chosen(int band, int first, int end, const Columns& columns, Real* rows) const;
  template <typename Real>
  void unpack_sparse(int band, int first, int end, const Columns& columns, Real* rows) const;
  template <typename Real>
  void unpack_block(int band, int block, int first, int end, const Columns& columns,
                    Real* rows) const;

  std::int32_t length_ = 0;
  std::int32_t signals_ = 0;
  Wavelet wavelet_ = Wavelet::Cubic;
  std::uint8_t band_count_ = 1;
  std::uint16_t double_precision_count_ = 0;
  std::uint32_t wide_ = 0;  // offsets from this
  std::uint32_t steps_ = 0;
  std::uint32_t entries_ = 0;
};

}  // namespace mocapress::runtime
