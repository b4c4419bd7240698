// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/feet/contact_spans.h"

class QGridLayout;
class QLabel;
class QTreeView;

namespace mocapress {

class SlideModel;

/// The findings of footskate, each a click away, and the thresholds by which contacts are found.
class FootskatePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FootskatePanel(SlideModel* model, QWidget* parent = nullptr);

  /// In one line, above the list.
  void setSummary(const QString& summary);

  const ContactSettings& settings() const { return settings_; }

 signals:
  /// The frame where it is worst, and the joint or end that slides.
  void findingChosen(int frame, int landmark);
  void settingsChanged(const ContactSettings& settings);

 private:
  void addThreshold(QGridLayout* grid, int row, int column, double* value, const QString& unit,
                    const QString& name);

  ContactSettings settings_;
  QLabel* summary_;
  QTreeView* view_;
};

}  // namespace mocapress
