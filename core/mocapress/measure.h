// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/mocapress/motion.h"
#include "core/report/measurement.h"

namespace mocapress {

/// How far a .mcpr of any method is from its original, and what it costs: errors in cm, bytes,
/// ratio, what the feet slide. What only encoding knows (seconds, iterations, coefficient ratio) is
/// left unset. Throws FormatError for bytes that are no .mcpr, Error for one of another shape than
/// `original`: other channels or another number of frames.
Measurement measure(const Motion& original, std::span<const std::byte> file);

}  // namespace mocapress
