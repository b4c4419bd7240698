// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/codec/encode/options/important_range.h"

namespace mocapress {

/// Sets the factor of these frames; 1 removes it. Adjacent ranges with equal factors become one.
/// The result is sorted by time.
std::vector<ImportantRange> withCareOver(const std::vector<ImportantRange>& ranges, int first_frame,
                                         int last_frame, double factor);

/// The largest factor among the ranges that contain all of these frames; 1: no range does.
double careOver(const std::vector<ImportantRange>& ranges, int first_frame, int last_frame);

}  // namespace mocapress
