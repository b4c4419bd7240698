// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/jobs/clips.h"
#include "widgets/models/library_entry.h"

namespace mocapress {

/// What a compression by these options came to, and whether it met its target. Requires a
/// distortion.
Outcome outcomeOf(const DecodedClip& decoded, const EncodeOptions& options);

}  // namespace mocapress
