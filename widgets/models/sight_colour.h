// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "core/metrics/visibility.h"

namespace mocapress {

/// Slate, amber, vermilion: told apart in all kinds of colour vision and by how light they are.
QColor sightColour(Sight sight);

/// The same by how many times an error is what is noticed: what is not visible is the darker the
/// less there is of it.
QColor sightColour(double times_noticed);

}  // namespace mocapress
