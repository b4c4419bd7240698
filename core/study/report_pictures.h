// SPDX-License-Identifier: MIT
// Based on: "Adapting Wavelet Compression to Human Motion Capture Clips", Figures 1, 3 and 4.
#pragma once

#include <string>

#include "core/report/picture.h"

namespace mocapress {

/// The worst frame of each method side by side, a sequence of frames, and the foot that slid most.
std::string picture_section(const Picture& picture);

}  // namespace mocapress
