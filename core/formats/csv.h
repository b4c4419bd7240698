// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/clip.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// "time_s,root.tx_cm,lfemur.rx_rad,...,face.smile", then one line a frame.
std::string csv_text(const Motion& motion, const ScalarTracks& tracks = {});

}  // namespace mocapress
