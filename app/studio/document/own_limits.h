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

/// Writes the file and uses the limits from now on. Throws WriteError.
void setOwnLimits(const SightLimits& limits);

/// The options with the user's limits, unless a preset or project brought some. The viewing
/// distance stays.
EncodeSettings withOwnLimits(EncodeSettings options);

}  // namespace mocapress
