// SPDX-License-Identifier: MIT
// Biovision hierarchies. Angles are degrees; the file says neither its unit of length nor whether a
// translation channel adds to the joint's OFFSET or replaces it: bvh_conventions.h guesses both.
#pragma once

#include <string>
#include <string_view>

#include "core/formats/motion_file.h"

namespace mocapress {

/// Reads the text of a .bvh; `file` names it in messages. Throws InputError.
MotionFile read_bvh(const std::string& file, std::string_view text,
                    const ReadOptions& options = {});

/// Centimetres and degrees. A root that moves has OFFSET 0 and its position in its channels;
/// another joint with translation channels repeats its OFFSET in them, so that both conventions, or
/// the more widespread one, give the same motion. Joints turned by ASF's `axis` get the order Z Y
/// X.
std::string bvh_text(const Motion& motion);

}  // namespace mocapress
