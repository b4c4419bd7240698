// SPDX-License-Identifier: MIT
// What each coefficient contributes to a signal at one instant: the inverse transform read
// backwards, from the samples of the two frames around the instant up to the coarser bands.
#pragma once

#include <cstdint>

#include "core/codec/format/bands.h"
#include "core/codec/format/kinds.h"

namespace mocapress::runtime {

/// Weights of consecutive rows from `first` on; beyond those that exist they are zero.
struct RowWeights {
  int first = 0;
  float weight[8] = {};
};

/// The weights of even samples and details that make up samples with these weights, six at most, of
/// a signal of so many. Six evens, seven details.
/// Returns whether no border is near.
bool weigh_level(Wavelet wavelet, int length, const RowWeights& samples, RowWeights& evens,
                 RowWeights& details);

}  // namespace mocapress::runtime
