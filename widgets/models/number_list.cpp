// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/number_list.h"

#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace mocapress {

QString numbersText(const std::vector<double>& numbers, const QLocale& locale) {
  QStringList texts;
  QLocale plain = locale;
  plain.setNumberOptions(QLocale::OmitGroupSeparator);
  for (const double number : numbers)
    texts << plain.toString(number, 'g', QLocale::FloatingPointShortest);
  return texts.join(QLatin1Char(' '));
}

std::optional<std::vector<double>> parseNumbers(const QString& text, const QLocale& locale) {
  static const QRegularExpression kBetween(QStringLiteral("[\\s;]+"));
  static const QRegularExpression kBetweenOrComma(QStringLiteral("[\\s;,]+"));
  const bool comma_is_point = locale.decimalPoint() == QLatin1String(",");
  std::vector<double> numbers;
  for (const QString& word :
       text.split(comma_is_point ? kBetween : kBetweenOrComma, Qt::SkipEmptyParts)) {
    bool is_number = false;
    const double number = locale.toDouble(word, &is_number);
    if (!is_number || !(number > 0) || !std::isfinite(number)) return std::nullopt;
    if (std::find(numbers.begin(), numbers.end(), number) == numbers.end())
      numbers.push_back(number);
  }
  return numbers;
}

}  // namespace mocapress
