// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>
#include <vector>

namespace mocapress {

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
