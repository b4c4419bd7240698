// SPDX-License-Identifier: MIT
// A queue: a file that describes a batch for another machine, with presets, formats, and every clip
// with its settings.
#pragma once

#include <string>

#include "core/batch/batch.h"

namespace mocapress {

std::string queue_text(const Batch& batch);

/// Parses a queue. Throws InputError.
Batch parse_queue(const std::string& file, const std::string& text);

}  // namespace mocapress
