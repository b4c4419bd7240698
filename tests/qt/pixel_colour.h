// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>
#include <algorithm>
#include <cstdlib>

namespace mocapress {

inline bool isRed(QRgb pixel) {
  return qRed(pixel) > 2 * qGreen(pixel) && qRed(pixel) > 2 * qBlue(pixel);
}

inline bool isGrey(QRgb pixel) {
  const auto [least, most] = std::minmax({qRed(pixel), qGreen(pixel), qBlue(pixel)});
  return most - least < 40;
}

inline int difference(QRgb a, QRgb b) {
  return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) +
         std::abs(qBlue(a) - qBlue(b));
}

}  // namespace mocapress
