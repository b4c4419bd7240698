// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace mocapress {

/// Sentences of core, with %1 and on for what differs; translatedSentence() looks them up.

/// Says what is wrong with the bytes of a file: .mcpr and its parts, FBX, glTF.
std::span<const char* const> sentencesOfBytes();

/// Says what cannot be compressed or written, and what is wrong with settings, projects and
/// batches.
std::span<const char* const> sentencesOfWork();

}  // namespace mocapress
