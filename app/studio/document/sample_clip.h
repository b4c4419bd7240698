// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

/// The bundled walk: from the installed share directory, or from the source tree where the program
/// runs out of its build directory. Empty: neither is there.
QString sampleClip();

}  // namespace mocapress
