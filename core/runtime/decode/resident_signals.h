// SPDX-License-Identifier: MIT
// The motion as an engine keeps it in memory: quantised coefficients, ordered by band and time. Any
// rows of any band can be unpacked by themselves. A signal is a channel, a coordinate of an
// effector's offset, or a curve track.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/bands.h"
#include "core/runtime/format/kinds.h"

namespace mocapress::runtime {

/// The quantised coefficients, and what else is needed to make a resident form.
struct QuantisedSource {
  int length;  // coefficients per signal, coarse to fine
  int signal_count;
  Wavelet wavelet;
  const float* steps;  // one per signal, for depth 0 (Bands::depth)
  /// For each signal: the largest sample that floats are precise enough for.
  const float* double_precision_limits;
  const std::int32_t* values;  // one signal after the other
  std::uint8_t* notes;         // work space, one byte per signal
  std::uint64_t budget_bytes;  // a band takes the smaller of its two forms; within this total size,
                               // coarse bands may be dense though that is larger
};

/// The dimensions that determine the work space for decoding signals.
struct SignalsShape {
  int length = 0;
  int signal_count = 0;
  int double_precision_count = 0;  // signals decoded in double precision
};

/// The resident form of a motion. It has no pointers, but offsets in bytes from `this`.
///
/// Each band is stored as dense, sparse or empty. Dense: row after row, where each coefficient
/// takes as many bits as its signal needs in this band. Sparse: blocks of 2^k rows; a block lists
/// the nonzero values, signal after signal, each with the number of zeros before it. A band takes
/// the smaller form; but coarse bands are dense, which is faster to decode, as far as a budget
/// allows.
class ResidentSignals {
 public:
  /// Size of the form that build() makes.
  static std::uint64_t size(const QuantisedSource& source);

  /// Builds at `memory`, which must be zeroed and aligned.
  static const ResidentSignals* build(const QuantisedSource& source, std::byte* memory);

  /// True if a form from an untrusted source has this length and number of signals, and can be
  /// decoded without reading outside its `bytes`. `this` must be aligned and the head must be
  /// readable.
  bool is_sound(std::uint64_t bytes, std::uint32_t length, std::uint32_t signals) const;

  int length() const { return length_; }
  int signal_count() const { return signals_; }
  Wavelet wavelet() const { return wavelet_; }
  int band_count() const { return band_count_; }
  SignalsShape shape() const { return {length_, signals_, double_precision_count_}; }

  /// Number of signals to be decoded in double precision.
  int double_precision_count() const { return double_precision_count_; }
  const std::uint16_t* double_precision_signals() const { return at<std::uint16_t>(wide_); }

  float step(int signal) const { return steps()[signal]; }  // at depth 0 (Bands::depth)

  bool is_empty(int band) const { return entries()[band].kind == Kind::Empty; }

  /// Destination of unpacked values.
  struct Columns {
    const std::int32_t* of_signal;  // column of each signal; kNone: left out
    bool in_order;          // the first signals go to the columns in order: signal s to column s
    std::ptrdiff_t stride;  // floats from row to row, a multiple of 8
    const RowKernels* kernels;
    static constexpr std::int32_t kNone = -1;
  };

  /// Unpacks rows first ... end - 1 of a band, and multiplies the values by their quantisation
  /// steps. The band must not be empty. `rows` are `columns.stride` numbers apart; columns without
  /// a signal get unspecified values.
  template <typename Real>
  void unpack(int band, int first, int end, const Columns& columns, Real* rows) const;

 private:
  static constexpr int kCountShift = 3;  // shift of the Rice code for the number of values in a
                                         // block
  /// SparseWide: sparse, with offsets of blocks in 32 bits instead of 16.
  enum class Kind : std::uint8_t { Empty, Dense, Sparse, SparseWide };
  friend class ResidentBuilder;
  friend class ResidentChecker;

  struct BandEntry {
    Kind kind = Kind::Empty;
    std::uint8_t log2_rows = 0;  // logarithm of the number of rows in a block
    std::uint8_t gap_shift = 0;  // this and the next: shifts of the Rice codes for gaps and values
    std::uint8_t value_shift = 0;
    std::uint32_t present = 0;      // sparse: number of signals with values; dense: bytes in a row
    std::uint32_t offset = 0;       // sparse: offsets of the blocks; dense: widths of the signals
    std::uint32_t list_offset = 0;  // sparse only: list of the signals with values
    std::uint32_t bits_offset = 0;
  };

  template <typename T>
  const T* at(std::uint32_t offset) const {
    return reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(this) + offset);
  }
  /// One step per signal, padded with zeros to a full group of 8.
  const float* steps() const { return at<float>(steps_); }
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
  std::uint32_t wide_ = 0;  // this and the next are offsets from `this`
  std::uint32_t steps_ = 0;
  std::uint32_t entries_ = 0;
};

}  // namespace mocapress::runtime
