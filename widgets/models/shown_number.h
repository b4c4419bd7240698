// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>

namespace mocapress {

/// As the user's language writes it.
inline QString shown(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

/// With three significant digits.
inline QString shownFigure(double value) {
  return shown(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

}  // namespace mocapress
