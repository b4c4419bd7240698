// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace mocapress {

/// Loads the drawing `name` from resources/icons in the palette's text colour, light or dark.
QIcon themedIcon(const QString& name);

}  // namespace mocapress
