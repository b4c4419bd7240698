// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

namespace mocapress {

/// Formats a number in the user's language.
inline QString shown(double value, int decimals) {
  return QLocale().toString(value, 'f', decimals);
}

/// Formats a number with at most three digits and two decimals: "1.95", "29.7", "176".
inline QString shownShort(double value) {
  return shown(value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0);
}

/// Formats a number with three significant digits.
inline QString shownFigure(double value) {
  return shown(value, value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3);
}

/// A ratio with up to three digits: "176 : 1", "29.7 : 1".
QString ratioText(double ratio);

/// A size of a file with up to three digits: "812 bytes", "1.04 kB".
QString sizeText(double bytes);

/// A distance with up to three digits, in millimetres below a centimetre: "12.3 cm", "4.6 mm",
/// "0.04 mm". Never "0.00 cm".
QString lengthText(double cm);

/// Formats the amount by which one distance exceeds another: "+1.51 cm"; "0 mm" if it does not.
QString surplusText(double cm);

/// A round distance, as on a scale: "5 mm", "1 cm".
QString roundLengthText(double cm);

/// An angle: "12.3°", "1.2°", "0.34°". Never "0.00°".
QString angleText(double degrees);

/// A round angle, as on a scale: "2.5°".
QString roundAngleText(double degrees);

/// A duration: "0:42", "1:05:10".
QString clockText(double seconds);

/// Lists numbers in the locale's notation: "0.1 0.26 0.5".
QString numbersText(const std::vector<double>& numbers, const QLocale& locale = {});

/// Parses a list of positive numbers and removes repetitions. Numbers are separated by spaces,
/// semicolons, and, unless the locale uses them in numbers, commas. Unset if any part is not a
/// positive number.
std::optional<std::vector<double>> parseNumbers(const QString& text, const QLocale& locale = {});

}  // namespace mocapress
