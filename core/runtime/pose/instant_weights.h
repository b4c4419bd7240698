// SPDX-License-Identifier: MIT
// The weight that each coefficient has in a signal's value at one instant. The weights are found by
// running the inverse transform backwards: from the two frames around the instant to coarser and
// coarser bands. Away from the borders they come from tables, because they repeat with the frame's
// position between coarse samples.
#pragma once

#include <cstdint>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Weights of eight consecutive rows from `first` on. Rows that do not exist have weight zero.
struct RowWeights {
  int first = 0;
  float weight[8] = {};
};

/// Runs one level of the inverse transform backwards. Given the weights of at most six samples, in
/// a signal of `length` >= 4, finds those of the even samples and details from which these samples
/// are made: at most six even samples, and seven details from an even row on.
void weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details);

struct SampleWeights {
  int first_row;
  float of_row[kSampleWindow];
};

/// All weights at one instant of a segment: of the details in each band, the finest first; and of
/// the samples that remain when 0, 1, 2 ... bands are left out.
struct InstantWeights {
  BandWeights band[kMostKeptBands];
  SampleWeights samples[kMostKeptBands + 1];
  int levels = 0;
  float unit = 1;  // factor by which the integer weights of all bands were divided

  /// Finds the weights at the instant `share` after `frame`, in a segment of `length` frames with
  /// up to `kept` bands. Bit n of `wanted`: the weights of samples without the n finest bands are
  /// needed; those without all `kept` bands are always found.
  void set(const PoseKernels& kernels, Wavelet wavelet, int length, int frame, float share,
           int kept, unsigned wanted);
};

}  // namespace mocapress::runtime
