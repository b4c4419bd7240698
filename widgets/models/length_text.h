// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace mocapress {

/// A distance to three digits at most, in millimetres below a centimetre: "12.3 cm", "4.6 mm",
/// "0.04 mm", and never "0.00 cm".
QString lengthText(double cm);

/// A round distance, as on a scale: "5 mm", "1 cm".
QString roundLengthText(double cm);

}  // namespace mocapress
