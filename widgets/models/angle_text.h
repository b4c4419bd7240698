// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

/// By how much something is turned: "12.3°", "1.2°", "0.34°", and never "0.00°".
QString angleText(double degrees);

/// A round angle, as on a scale: "2.5°".
QString roundAngleText(double degrees);

}  // namespace mocapress
