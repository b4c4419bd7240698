// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace mocapress {

/// The drawing of that name in resources/icons, always in the palette's text colour, light or dark.
QIcon themedIcon(const QString& name);

}  // namespace mocapress
