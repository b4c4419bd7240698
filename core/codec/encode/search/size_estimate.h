// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/codec/format/adaptive.h"

namespace mocapress {

/// What the bytes of a coded motion go to, roughly, in bytes.
struct SizeParts {
  double details = 0;  // how large they are, counted by what is around them
  double signs = 0;    // of these, all at even odds
  double coarse = 0;   // differences between coarse samples
  double bands = 0;    // whether they have anything, where they have
  double signals = 0;  // one each: steps, first samples
};

SizeParts size_parts(const QuantisedSignals& coded,
                     const std::vector<SignalNeighbours>& neighbours);

/// About how many bytes adaptive_encode() makes of signals, in a hundredth of its time. How near
/// that is: ADAPTIVE.md, "Drafts".
std::size_t estimated_bytes(const QuantisedSignals& coded,
                            const std::vector<SignalNeighbours>& neighbours);

}  // namespace mocapress
