// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/result_panel.h"

class QHBoxLayout;
class QLabel;

namespace mocapress {

/// Error and size in one line at the foot of the window, in sight whatever panels are open.
class FiguresBar : public QWidget {
  Q_OBJECT

 public:
  explicit FiguresBar(QWidget* parent = nullptr);

  /// Unset: dashes.
  void setFigures(const std::optional<ResultFigures>& figures);

 private:
  /// A name and what belongs to it.
  struct Figure {
    QLabel* caption;
    QLabel* value;
  };
  Figure add(QHBoxLayout* row, const QString& name, const QString& explanation);

  Figure eps_;
  Figure p95_;
  Figure p99_;
  Figure max_;
  Figure footskate_;
  Figure size_;
  Figure ratio_;
  Figure bits_;
};

}  // namespace mocapress
