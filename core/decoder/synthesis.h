// SPDX-License-Identifier: MIT
// Based on: W. Sweldens, "The lifting scheme: a construction of second generation wavelets", 1998;
// the transform is that of core/wavelet/lifting.h, from the coarse samples down, only where asked.
#pragma once

#include "memory.h"
#include "resident_signals.h"
#include "row_kernels.h"

namespace mocapress::decoder {

/// Which signals come out, in which columns, how detailed.
struct SynthesisPlan {
  const std::int32_t* column_of_signal;  // ResidentSignals::Columns::kNone: left out
  int columns;
  int bands_left_out;  // of the finest: as if they were zero
  const RowKernels* rows;
};

/// The inverse transform of any window of frames: at each band no more rows than the window needs.
class Synthesis {
 public:
  static constexpr int kWindow = 64;  // frames at a time: what fits the first cache

  /// Takes the memory it works in. With measuring memory only that.
  Synthesis(Memory& memory, const ResidentSignals& signals, const SynthesisPlan& plan);

  /// Rows are this many floats apart: the columns and what rounds them up.
  std::ptrdiff_t stride() const { return stride_; }

  /// The samples of frames first ... first + count - 1, row after row, in memory of this until the
  /// next call, which the caller may change. 0 < count <= kWindow, and all frames exist.
  float* window(int first, int count);

 private:
  struct Range {
    int first;
    int end;
  };

  void find_needs(int first, int count);
  const float* unpack_details(int band, Range evens);
  void place_evens(int band, Range evens, const float* coarse, const float* details, float* out);
  void place_odds(int band, Range evens, const float* details, float* out);
  void place_odd_at_border(int band, int odd, Range evens, const float* detail, float* out);
  bool has_details(int band) const;
  int first_detail(Range evens) const { return evens.first > 0 ? evens.first - 1 : 0; }

  const ResidentSignals& signals_;
  SynthesisPlan plan_;
  Bands bands_;
  std::ptrdiff_t stride_;
  Range needs_[kMostBands] = {};  // samples of the signal that bands 0 ... b make up
  float* samples_;                // rows: what was made, and what is being made of it
  float* made_;
  float* details_;
  float* zeros_;  // a row
};

}  // namespace mocapress::decoder
