// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/log_ticker.h"

#include <cmath>

namespace mocapress {
namespace {

/// Whether a digit is labelled in a range of so many decades.
bool labelled(int digit, double decades) {
  if (digit == 1 || decades < 0.9) return true;
  return decades < 4.6 && (digit == 2 || digit == 5);
}

}  // namespace

QVector<double> LogTicker::createTickVector(double, const QCPRange& range) {
  QVector<double> ticks;
  if (!(range.lower > 0)) return ticks;
  const double decades = std::log10(range.upper / range.lower);
  for (double decade = std::pow(10, std::floor(std::log10(range.lower))); decade <= range.upper;
       decade *= 10)
    for (int digit = 1; digit < 10; ++digit)
      if (labelled(digit, decades) && digit * decade >= range.lower &&
          digit * decade <= range.upper)
        ticks << digit * decade;
  return ticks;
}

QString LogTicker::getTickLabel(double tick, const QLocale& locale, QChar, int) {
  return locale.toString(tick, 'g', 3) + unit_;
}

}  // namespace mocapress
