// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/number_list_edit.h"

#include "widgets/models/number_list.h"

namespace mocapress {

NumberListEdit::NumberListEdit(QWidget* parent) : QLineEdit(parent) {
  connect(this, &QLineEdit::textEdited, this, &NumberListEdit::read);
  connect(this, &QLineEdit::editingFinished, this, [this] {
    setText(numbersText(numbers_, locale()));
    mark(false);
  });
}

void NumberListEdit::setNumbers(const std::vector<double>& numbers) {
  if (numbers == numbers_) return;  // also while they are typed
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
