// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/angle_text.h"

#include "widgets/models/shown_number.h"

namespace mocapress {
namespace {

constexpr double kLeastDegrees = 0.005;  // shown: less is not zero either

QString inDegrees(const QString& number) {
  return number + QStringLiteral("°");
}

}  // namespace

QString angleText(double degrees) {
  if (degrees <= 0) return inDegrees(shown(0, 0));
  if (degrees < kLeastDegrees) return QStringLiteral("< ") + inDegrees(shown(0.01, 2));
  return inDegrees(shown(degrees, degrees < 0.995 ? 2 : degrees < 99.95 ? 1 : 0));
}

QString roundAngleText(double degrees) {
  return inDegrees(QLocale().toString(degrees, 'g', 3));
}

}  // namespace mocapress
