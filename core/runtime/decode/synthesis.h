// SPDX-License-Identifier: MIT
// The inverse wavelet transform, for windows of frames. Based on: W. Sweldens, "The lifting scheme:
// a construction of second generation wavelets", 1998. It inverts core/wavelet/lifting.h, from the
// coarse samples to the fine ones, and computes only what a window needs.
#pragma once

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

inline constexpr int kWindow = 128;  // frames per window; chosen so that its rows fit into the
                                     // caches near the core

/// The wanted signals, their columns and the level of detail.
template <typename Real>
struct SynthesisPlan {
  ResidentSignals::Columns columns;
  int count;           // number of columns
  int bands_left_out;  // finest bands, treated as zero
  const LiftingKernels<Real>* kernels;
};

/// Inverse transform of any window of frames. In each band, rows left from the previous window are
/// kept; only the others that the window needs are computed.
template <typename Real>
class Synthesis {
 public:
  static constexpr int kWindow = mocapress::runtime::kWindow;

  /// Takes work space from `memory`. If `memory` only measures, this counts bytes and does nothing
  /// else; `motion` may then be null.
  Synthesis(Memory& memory, const ResidentSignals* motion, int length,
            const SynthesisPlan<Real>& plan);

  /// Computes frames first ... first + count - 1, as rows of plan.count numbers, out_step apart.
  /// `count` is 1 ... kWindow, and all frames must exist.
  void decode_window(int first, int count, Real* out, std::ptrdiff_t out_step);

 private:
  struct Range {
    int first = 0;
    int end = 0;
    bool is_empty() const { return first >= end; }
  };

  /// Rows of a band that are kept from window to window.
  struct Held {
    Real* memory = nullptr;
    int capacity = 0;
    Real* rows = nullptr;  // row of range.first
    Range range;
  };

  /// The rows from which the samples of a band are made: the even samples, which are the samples of
  /// the coarser band after the update step, and the details.
  struct Level {
    Held evens;
    Held details;
    Range wanted;       // samples to make
    Range needs_evens;  // even samples needed for `wanted`
  };

  void find_needs(int first, int count);
  void hold(Held& held, Range range);
  const Real* even_row(int band, int i) const;
  const Real* detail_row(int band, int i) const;
  bool has_details(int band) const;
  void unpack_details(int band, Range new_evens);
  Real* evens_to_come(int band);
  void put_coarse(Real* out, std::ptrdiff_t out_step);
  void update_evens(int band, Range added);
  void update_rows(int band, int first, int end, int before, int after);
  void put_samples(int band, Real* out, std::ptrdiff_t out_step, std::ptrdiff_t width);
  void put_odds(int band, int first, int end, Real* out, std::ptrdiff_t out_step,
                std::ptrdiff_t width);
  void put_odd_at_border(int band, int odd, Real* out, std::ptrdiff_t width);

  const ResidentSignals* signals_;
  SynthesisPlan<Real> plan_;
  Bands bands_;
  std::ptrdiff_t stride_;     // numbers per row: the columns, rounded up to a multiple of 8
  Range coarse_;              // coarse samples to unpack
  Level levels_[kMostBands];  // element 0 is not used
  Real* coarse_samples_;      // work space for signals that have a single band
  Real* zeros_;               // a row of zeros
};

}  // namespace mocapress::runtime
