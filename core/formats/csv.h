// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/motion/clip.h"
#include "core/motion/scalar_track.h"

namespace mocapress {

/// The text of a .csv: "time_s,root.tx_cm,lfemur.rx_rad,...,face.smile", then one line a frame.
std::string csv_text(const Motion& motion, const ScalarTracks& tracks = {});

/// Reads curves that a motion file lacks, such as custom properties, IK and event curves: a line of
/// names, then one line of numbers a frame. A first column time_s is left out. Curves of whole
/// numbers are switches, which step from frame to frame. `file` names it in messages. Throws
/// InputError.
ScalarTracks read_csv_tracks(const std::string& file, std::string_view text, int frames);

}  // namespace mocapress
