// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/motion/clip.h"

namespace mocapress {

/// 16 hexadecimal digits that change with any sample, the rate or the skeleton: tells a changed
/// clip from the one a row was measured on. Not against malice.
std::string fingerprint(const Motion& motion);

}  // namespace mocapress
