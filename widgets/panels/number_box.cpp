// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/number_box.h"

namespace mocapress {
namespace {

constexpr double kMost = 1e9;
const QString kWidest = QStringLiteral("1000000 bytes");

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setRange(0, kMost);
  setAlignment(Qt::AlignRight);
  setKeyboardTracking(false);
  setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
}

void NumberBox::setDecimalsShown(int shown, int most) {
  shown_ = shown;
  setDecimals(most);
}

QSize NumberBox::sizeHint() const {
  constexpr int kFrameAndButtons = 36;  // pixels
  return {fontMetrics().horizontalAdvance(kWidest) + kFrameAndButtons,
          QDoubleSpinBox::sizeHint().height()};
}

QString NumberBox::textFromValue(double value) const {
  QString text = QDoubleSpinBox::textFromValue(value);
  const auto point = text.indexOf(locale().decimalPoint());
  if (point < 0) return text;
  auto length = text.size();
  while (length > point + 1 + shown_ && text[length - 1] == locale().zeroDigit()[0]) --length;
  return text.left(length == point + 1 ? point : length);
}

}  // namespace mocapress
