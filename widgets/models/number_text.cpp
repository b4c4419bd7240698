// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/number_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>
#include <cmath>

namespace mocapress {

namespace {

struct Lengths {
  Q_DECLARE_TR_FUNCTIONS(mocapress::Lengths)
};

constexpr double kMillimetres = 10;    // millimetres in a centimetre
constexpr double kShownAsOne = 0.995;  // cm: from here on two decimals would show 1.00
constexpr double kLeastShown = 0.005;  // mm: smaller values are shown with a <

}  // namespace

QString lengthText(double cm) {
  if (cm >= kShownAsOne) return Lengths::tr("%1 cm").arg(shownShort(cm));
  const double mm = kMillimetres * cm;
  if (mm <= 0) return Lengths::tr("%1 mm").arg(shown(0, 0));
  if (mm < kLeastShown) return Lengths::tr("< %1 mm").arg(shown(0.01, 2));
  return Lengths::tr("%1 mm").arg(shown(mm, mm < 0.095 ? 2 : 1));
}

QString ratioText(double ratio) {
  return Lengths::tr("%1 : 1").arg(shownShort(ratio));
}

QString sizeText(double bytes) {
  double in_unit = bytes;
  while (in_unit >= 999.5) in_unit /= 1000;
  const int decimals = bytes < 999.5 || in_unit >= 99.95 ? 0 : in_unit >= 9.995 ? 1 : 2;
  return QLocale().formattedDataSize(std::llround(bytes), decimals, QLocale::DataSizeSIFormat);
}

QString surplusText(double cm) {
  return (cm > 0 ? QStringLiteral("+") : QString()) + lengthText(cm);
}

QString roundLengthText(double cm) {
  const bool small = cm < kShownAsOne;
  const QString text = QLocale().toString(small ? kMillimetres * cm : cm, 'g', 3);
  return (small ? Lengths::tr("%1 mm") : Lengths::tr("%1 cm")).arg(text);
}

namespace {

constexpr double kLeastDegrees = 0.005;  // smaller values are shown with a <

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

QString clockText(double seconds) {
  const auto whole = static_cast<int>(std::lround(seconds));
  const auto two = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QChar(u'0')); };
  const QString rest = two(whole % 60);
  if (whole < 3600) return QStringLiteral("%1:%2").arg(whole / 60).arg(rest);
  return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(two(whole / 60 % 60), rest);
}

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
