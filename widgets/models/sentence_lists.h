// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace mocapress {

/// Sentences of core that translatedSentence() looks up; %1, %2 and so on stand for parts that
/// vary.

/// Errors in the bytes of a file: .mcpr and its parts, FBX, glTF.
std::span<const char* const> sentencesOfBytes();

/// Reasons why something cannot be compressed or written, and errors in settings, projects and
/// batches.
std::span<const char* const> sentencesOfWork();

}  // namespace mocapress
