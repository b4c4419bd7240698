// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/batch/preset.h"
#include "core/motion/body_part.h"

namespace mocapress {

/// What people read: the built-in ones in their language, their own as they called them.
QString displayName(const Preset& preset);

/// What a built-in preset is for; empty for any other.
QString purposeOf(const Preset& preset);

/// "Feet × 4, contacts × 20; effort: best": what of a preset is not seen elsewhere; may be empty.
QString detailsOf(const Preset& preset);

QString displayName(BodyPart part);
QString displayName(Effort effort);
QString displayName(Ends ends);

/// "Feet × 4, contacts × 20"; empty where all are alike.
QString importanceText(const NamedImportance& importance);

}  // namespace mocapress
