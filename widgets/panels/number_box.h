// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDoubleSpinBox>

namespace mocapress {

/// A number of any size, taken as it is typed: what a range would cut off is for others to judge.
/// Shows no more decimals than it has, and keeps its width whatever it holds.
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

 private:
  int shown_ = 0;
};

}  // namespace mocapress
