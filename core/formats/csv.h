// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/clip.h"

namespace mocapress {

/// "time_s,root.tx_cm,lfemur.rx_rad,...", then one line a frame.
std::string csv_text(const Motion& motion);

}  // namespace mocapress
