// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

namespace mocapress {

inline bool isRed(QRgb pixel) {
  return qRed(pixel) > 2 * qGreen(pixel) && qRed(pixel) > 2 * qBlue(pixel);
}

}  // namespace mocapress
