// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <vector>

namespace mocapress {

/// A number of any size, taken as it is typed: what a range would cut off is for others to judge.
/// Shows no more decimals than it has, and keeps its width whatever it holds. Decimals beyond the
/// third digit of a number that is typed are rounded away.
class NumberBox : public QDoubleSpinBox {
  Q_OBJECT

 public:
  explicit NumberBox(QWidget* parent = nullptr);

  /// At least `shown` decimals, at most `most`.
  void setDecimalsShown(int shown, int most);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;

 private:
  int shown_ = 0;
};

/// Positive numbers in a line, separated by spaces. What cannot be read is marked, and changes
/// nothing.
class NumberListEdit : public QLineEdit {
  Q_OBJECT

 public:
  explicit NumberListEdit(QWidget* parent = nullptr);

  void setNumbers(const std::vector<double>& numbers);
  const std::vector<double>& numbers() const { return numbers_; }

 signals:
  /// By the user.
  void numbersChanged();

 private:
  void read(const QString& text);
  void mark(bool unreadable);

  std::vector<double> numbers_;
};

}  // namespace mocapress
