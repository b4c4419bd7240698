// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>

#include "app/studio/document/named_settings.h"

namespace mocapress {

/// A pinned result, as it is kept: by what it is made, not what was made.
struct Pin {
  QString name;
  QColor colour;
  NamedSettings settings;
};

}  // namespace mocapress
