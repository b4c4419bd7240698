// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>
#include <optional>
#include <vector>

namespace mocapress {

/// "0.1 0.26 0.5", in the notation of the locale.
QString numbersText(const std::vector<double>& numbers, const QLocale& locale = {});

/// The inverse: positive numbers between spaces, semicolons, or commas where the locale has no
/// other use for them. Without repetitions. Unset where something is no such number.
std::optional<std::vector<double>> parseNumbers(const QString& text, const QLocale& locale = {});

}  // namespace mocapress
