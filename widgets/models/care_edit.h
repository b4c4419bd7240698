// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/codec/encode/options/important_range.h"

namespace mocapress {

/// Gives these frames a factor in place of what they had; 1: none. Ranges of one factor that touch
/// become one. The result is in the order of time.
std::vector<ImportantRange> withCareOver(const std::vector<ImportantRange>& ranges, int first_frame,
                                         int last_frame, double factor);

/// The factor that one range gives to all of these frames; 1: no range has them all.
double careOver(const std::vector<ImportantRange>& ranges, int first_frame, int last_frame);

}  // namespace mocapress
