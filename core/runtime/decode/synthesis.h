// SPDX-License-Identifier: MIT
// Based on: W. Sweldens, "The lifting scheme: a construction of second generation wavelets", 1998;
// the transform is that of core/wavelet/lifting.h, from the coarse samples down, only where asked.
#pragma once

#include "core/runtime/decode/resident_signals.h"
#include "core/runtime/decode/row_kernels.h"
#include "core/runtime/format/memory.h"

namespace mocapress::runtime {

inline constexpr int kWindow = 128;  // frames at a time: what fits the nearer caches

/// Which signals come out, in which columns, how detailed.
template <typename Real>
struct SynthesisPlan {
  ResidentSignals::Columns columns;
  int count;           // of columns
  int bands_left_out;  // of the finest: as if they were zero
  const LiftingKernels<Real>* kernels;
};

/// The inverse transform of any window of frames: at each band no more rows than the window needs,
/// and none again that the window before it needed too.
template <typename Real>
class Synthesis {
 public:
  static constexpr int kWindow = mocapress::runtime::kWindow;

  /// Takes the memory it works in. With measuring memory only that, and `motion` may be null.
  Synthesis(Memory& memory, const ResidentSignals* motion, int length,
            const SynthesisPlan<Real>& plan);

  /// Makes the samples of frames first ... first + count - 1: rows of plan.count reals, out_step
  /// apart. 0 < count <= kWindow, and all frames exist.
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
    Real* rows = nullptr;  // of range.first
    Range range;
  };

  /// The rows that samples of a band are made of: even samples of the coarser bands, updated, and
  /// details.
  struct Level {
    Held evens;
    Held details;
    Range wanted;       // samples to make
    Range needs_evens;  // for that
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
  std::ptrdiff_t stride_;     // of rows here: the columns and what rounds them up
  Range coarse_;              // coarse samples to unpack
  Level levels_[kMostBands];  // from 1 on
  Real* coarse_samples_;      // where there is nothing else
  Real* zeros_;               // a row
};

}  // namespace mocapress::runtime
