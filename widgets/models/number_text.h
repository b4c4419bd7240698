// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

namespace mocapress {

/// As the user's language writes it.
inline QString shown(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

/// With three significant digits.
inline QString shownFigure(double value) {
  return shown(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

/// A distance to three digits at most, in millimetres below a centimetre: "12.3 cm", "4.6 mm",
/// "0.04 mm", and never "0.00 cm".
QString lengthText(double cm);

/// A round distance, as on a scale: "5 mm", "1 cm".
QString roundLengthText(double cm);

/// By how much something is turned: "12.3°", "1.2°", "0.34°", and never "0.00°".
QString angleText(double degrees);

/// A round angle, as on a scale: "2.5°".
QString roundAngleText(double degrees);

/// How long something takes: "0:42", "1:05:10".
QString clockText(double seconds);

/// "0.1 0.26 0.5", in the notation of the locale.
QString numbersText(const std::vector<double>& numbers, const QLocale& locale = {});

/// The inverse: positive numbers between spaces, semicolons, or commas where the locale has no
/// other use for them. Without repetitions. Unset where something is no such number.
std::optional<std::vector<double>> parseNumbers(const QString& text, const QLocale& locale = {});

}  // namespace mocapress
