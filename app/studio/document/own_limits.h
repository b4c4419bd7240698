// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/codec/encode/options/encode_settings.h"

namespace mocapress {

/// The file with the user's own limits of visibility, among the program's settings.
QString ownLimitsFile();

/// The limits in ownLimitsFile(), which is read once; the built-in ones if there is no such file.
/// `problem` is the reason why the file is not used; empty: no problem.
struct OwnLimits {
  SightLimits limits;
  QString problem;
};
const OwnLimits& ownLimits();

/// Writes the limits to the file and uses them from now on. Built-in limits remove the file. Throws
/// WriteError.
void setOwnLimits(const SightLimits& limits);

/// Replaces built-in limits by the user's own. Limits that a preset or project brought stay, and so
/// does the viewing distance.
SightLimits withOwnLimits(SightLimits limits);
EncodeSettings withOwnLimits(EncodeSettings options);

}  // namespace mocapress
