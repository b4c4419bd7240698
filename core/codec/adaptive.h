// SPDX-License-Identifier: MIT
// The coding "adaptive" of FORMAT.md: quantised coefficients, each bit predicted from what was
// coded before it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/codec/quantised_signals.h"
#include "core/motion/skeleton.h"

namespace mocapress {

/// Which signals resemble one another: an earlier signal, or -1 for none.
struct SignalKin {
  int sibling = -1;  // turns the same joint or, for the first of a joint, the one above
  int mirror = -1;   // on the other side of the body
};

/// Of a skeleton's channels, found from its tree alone.
std::vector<SignalKin> channel_kin(const Skeleton& skeleton);

/// The same for the differences of an IK correction, which follow the channels.
void append_correction_kin(int count, std::vector<SignalKin>& kin);

/// The coded bytes. `bands` are those of the transform.
std::vector<std::byte> adaptive_encode(const QuantisedSignals& coded,
                                       const std::vector<SignalKin>& kin,
                                       const std::vector<Band>& bands);

/// The inverse. Throws FormatError unless the bytes are those of signals of that shape.
QuantisedSignals adaptive_decode(std::span<const std::byte> bytes,
                                 const std::vector<SignalKin>& kin, const std::vector<Band>& bands);

}  // namespace mocapress
