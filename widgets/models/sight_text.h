// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "core/metrics/visibility.h"

namespace mocapress {

/// What is seen of a clip, as views share it; null: unknown.
using SightPtr = std::shared_ptr<const SightTable>;

/// "not visible", "borderline", "visible".
QString displayName(Sight sight);

/// "sliding foot".
QString displayName(Cue cue);

/// "borderline: velocity 5.2 cm/s, noticed from 3.1 cm/s".
QString sightText(const WorstSight& seen);

}  // namespace mocapress
