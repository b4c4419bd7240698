// SPDX-License-Identifier: MIT
// The weight of each coefficient in a signal's value at one instant. Found by running the inverse
// transform backwards, from the two frames around the instant up to the coarser bands. Away from
// the borders weights come from tables, as they repeat with the frame's position between coarse
// samples.
#pragma once

#include <cstdint>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Weights of consecutive rows from `first` on. Rows that do not exist have weight zero.
struct RowWeights {
  int first = 0;
  float weight[8] = {};
};

/// Runs one level of the inverse transform backwards: from weights of samples (six at most, of a
/// signal of `length` >= 4) to those of the even samples and details that they are made of. Gives
/// six even samples, and seven details starting at an even row.
void weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details);

struct SampleWeights {
  int first_row;
  float of_row[kSampleWindow];
};

/// All weights at one instant of a segment: for each band those of its details, the finest first;
/// and for the requested numbers of left-out bands those of the samples.
struct InstantWeights {
  BandWeights band[kMostKeptBands];
  SampleWeights samples[kMostKeptBands + 1];
  int levels = 0;
  float unit = 1;  // common factor of the integer weights of all bands

  /// Sets the weights for an instant `share` after `frame` in a segment of `length` frames, using
  /// up to `kept` bands. `wanted` has a bit for each number of bands whose samples are needed; the
  /// highest is always included.
  void set(const PoseKernels& kernels, Wavelet wavelet, int length, int frame, float share,
           int kept, unsigned wanted);
};

}  // namespace mocapress::runtime
