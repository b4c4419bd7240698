// SPDX-License-Identifier: MIT
// A queue as a file for another machine: presets, formats and every clip with its own settings.
#pragma once

#include <string>

#include "core/batch/batch.h"

namespace mocapress {

std::string queue_text(const Batch& batch);

/// Reads a queue of clips with their settings from JSON. Throws InputError.
Batch parse_queue(const std::string& file, const std::string& text);

}  // namespace mocapress
