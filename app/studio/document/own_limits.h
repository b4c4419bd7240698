// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/codec/encode/options/encode_settings.h"

namespace mocapress {

/// The file with the user's own limits of visibility, among the program's settings.
QString ownLimitsFile();

/// The limits in it; built-in ones without a file. Read once; `problem`, if there is one, says why
/// the file is not used.
struct OwnLimits {
  SightLimits limits;
  QString problem;
};
const OwnLimits& ownLimits();

/// Writes the file and uses the limits from now on; of built-in limits no file is left. Throws
/// WriteError.
void setOwnLimits(const SightLimits& limits);

/// The user's limits in place of built-in ones: those that a preset or project brought stay, and so
/// does the viewing distance.
SightLimits withOwnLimits(SightLimits limits);
EncodeSettings withOwnLimits(EncodeSettings options);

}  // namespace mocapress
