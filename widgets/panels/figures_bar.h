// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "widgets/panels/result_panel.h"

class QHBoxLayout;
class QLabel;

namespace mocapress {

/// Error and size in one line at the bottom of the window, visible whatever panels are open.
class FiguresBar : public QWidget {
  Q_OBJECT

 public:
  explicit FiguresBar(QWidget* parent = nullptr);

  /// Unset figures show as dashes.
  void setFigures(const std::optional<ResultFigures>& figures);

  /// Errors within a range of frames take the place of those of the clip; empty: no range.
  void setRange(const QString& errors);

 private:
  /// The widgets of one figure: its name and its value.
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
