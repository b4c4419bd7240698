// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "core/mocapress/motion.h"
#include "core/report/measurement.h"

namespace mocapress {

/// Measures a .mcpr of any method against its original: errors in cm, bytes, ratio, how far feet
/// slide, and what viewers notice by `limits`. Seconds, iterations and the coefficient ratio stay
/// unset, since only encoding knows them. Throws FormatError for bytes that are not a .mcpr, and
/// Error for a .mcpr with other channels or another number of frames than `original`.
Measurement measure(const Motion& original, std::span<const std::byte> file,
                    const SightLimits& limits = {});

}  // namespace mocapress
