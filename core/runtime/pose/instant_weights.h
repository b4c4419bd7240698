// SPDX-License-Identifier: MIT
// What each coefficient contributes to a signal at one instant: the inverse transform read
// backwards, from the samples of the two frames around the instant up to the coarser bands. Where
// no border is near, by tables: weights repeat with the places of frames between coarse samples.
#pragma once

#include <cstdint>

#include "core/runtime/format/bands.h"
#include "core/runtime/format/kinds.h"
#include "core/runtime/pose/cooked_clip.h"
#include "core/runtime/pose/pose_kernels.h"

namespace mocapress::runtime {

/// Weights of consecutive rows from `first` on; beyond those that exist they are zero.
struct RowWeights {
  int first = 0;
  float weight[8] = {};
};

/// The weights of even samples and details that make up samples with these weights, six at most, of
/// a signal of so many, at least 4. Six evens, seven details from an even row on.
void weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details);

struct SampleWeights {
  int first_row;
  float of_row[kSampleWindow];
};

/// What meets at an instant of a segment: of each band the weights of its details, the finest
/// first, and of some numbers of bands left out those of the samples.
struct InstantWeights {
  BandWeights band[kMostKeptBands];
  SampleWeights samples[kMostKeptBands + 1];
  int levels = 0;
  float unit = 1;  // the whole weights of all bands are to be multiplied by it once more

  /// `share` on the way from a frame to the next, of a segment of so many; up to `kept` bands.
  /// `wanted`: a bit for each number of bands whose samples are wanted; the highest always is.
  void set(const PoseKernels& kernels, Wavelet wavelet, int length, int frame, float share,
           int kept, unsigned wanted);
};

}  // namespace mocapress::runtime
