// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/codec/format/adaptive.h"

namespace mocapress {

/// The rough bytes of a coded motion, by kind.
struct SizeParts {
  double details = 0;  // magnitudes, coded by the sums around them
  double signs = 0;    // signs of the details, one bit each
  double coarse = 0;   // differences between coarse samples
  double bands = 0;    // flags of bands that are not all zero
  double signals = 0;  // a constant for each signal: step, first samples
};

SizeParts size_parts(const QuantisedSignals& coded,
                     const std::vector<SignalNeighbours>& neighbours);

/// Estimates the bytes that adaptive_encode() would make, in a hundredth of its time. Accuracy:
/// ADAPTIVE.md, "Drafts".
std::size_t estimated_bytes(const QuantisedSignals& coded,
                            const std::vector<SignalNeighbours>& neighbours);

}  // namespace mocapress
