// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/result_panel.h"

class QHBoxLayout;
class QLabel;

namespace mocapress {

/// Error and size in one line at the bottom of the window, visible whichever panels are open.
class FiguresBar : public QWidget {
  Q_OBJECT

 public:
  explicit FiguresBar(QWidget* parent = nullptr);

  /// Shows the measurements; dashes if unset.
  void setFigures(const std::optional<ResultFigures>& figures);

  /// Shows a text on the errors within a range of frames in place of the clip's errors; empty: no
  /// range.
  void setRange(const QString& errors);

 private:
  /// The labels of one number: its name and its value.
  struct Figure {
    QLabel* caption;
    QLabel* value;
  };
  Figure add(QHBoxLayout* row, const QString& name, const QString& explanation);

  QLabel* range_;
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
