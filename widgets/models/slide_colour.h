// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace mocapress {

/// How bad a slide is, 0 ... 1: a millimetre is nothing to be seen, two centimetres are as bad as
/// it gets.
float slideSeverity(double slid_cm);

/// From the teal of a foot that stands to the violet of one that slides: told apart without red and
/// green, and from a red figure.
QColor slideColour(double slid_cm);

}  // namespace mocapress
