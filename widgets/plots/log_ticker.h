// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

namespace mocapress {

/// Ticks of a logarithmic axis that is read at a glance: 1, 2, 5 of each decade, every digit of a
/// short range, whole decades of a long one.
class LogTicker : public QCPAxisTicker {
 public:
  /// `unit` follows each number: ":1".
  explicit LogTicker(const QString& unit = {}) : unit_(unit) {}

 protected:
  QVector<double> createTickVector(double, const QCPRange& range) override;
  double getTickStep(const QCPRange&) override { return 1; }
  int getSubTickCount(double) override { return 0; }
  QString getTickLabel(double tick, const QLocale& locale, QChar, int) override;

 private:
  QString unit_;
};

}  // namespace mocapress
