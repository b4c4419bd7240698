// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <vector>

namespace mocapress {

/// A spin box that accepts a number of any size; its owner judges the value. It shows only the
/// decimals that the number has, and keeps its width. Typed numbers are rounded to three
/// significant digits, or to whole numbers from 100 on.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit NumberBox(QWidget* parent = nullptr);

  /// Shows at least `shown` decimals and at most `most`.
  void setDecimalsShown(int shown, int most);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;

 private:
  int shown_ = 0;
};

/// Edits a list of positive numbers separated by spaces. Text that cannot be read is marked and
/// changes nothing.
class NumberListEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberListEdit(QWidget* parent = nullptr);

  void setNumbers(const std::vector<double>& numbers);
  const std::vector<double>& numbers() const { return numbers_; }

 signals:
  /// The user changed the numbers.
  void numbersChanged();

 private:
  void read(const QString& text);
  void mark(bool unreadable);

  std::vector<double> numbers_;
};

}  // namespace mocapress
