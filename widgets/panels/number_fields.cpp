// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/number_fields.h"

#include <cmath>

#include "widgets/models/log_scale.h"
#include "widgets/models/number_text.h"

namespace mocapress {

namespace {

constexpr double kMostNumber = 1e9;
const QString kWidest = QStringLiteral("1000000 bytes");

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
  setRange(0, kMostNumber);
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

double NumberBox::valueFromText(const QString& text) const {
  const double value = QDoubleSpinBox::valueFromText(text);
  return value >= 100 ? std::round(value) : value > 0 ? in_three_digits(value) : value;
}

NumberListEdit::NumberListEdit(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textEdited, this, &NumberListEdit::read);
  connect(this, &QLineEdit::editingFinished, this, [this] {
    setText(numbersText(numbers_, locale()));
    mark(false);
  });
}

void NumberListEdit::setNumbers(const std::vector<double>& numbers) {
  if (numbers == numbers_) return;  // keeps text that is being typed
  numbers_ = numbers;
  setText(numbersText(numbers, locale()));
  mark(false);
}

void NumberListEdit::read(const QString& text) {
  const auto numbers = parseNumbers(text, locale());
  mark(!numbers);
  if (!numbers || *numbers == numbers_) return;
  numbers_ = *numbers;
  emit numbersChanged();
}

void NumberListEdit::mark(bool unreadable) {
  QPalette marked;
  if (unreadable) marked.setColor(QPalette::Text, QColor(0xd55e00));
  setPalette(marked);
}

}  // namespace mocapress
