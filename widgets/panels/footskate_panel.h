// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/feet/contact_spans.h"

class QGridLayout;
class QLabel;
class QTreeView;

namespace mocapress {

class SlideModel;

/// Lists the footskate findings and edits the thresholds of contact detection. A click on a finding
/// seeks to it.
class FootskatePanel : public QWidget {
  Q_OBJECT

 public:
  explicit FootskatePanel(SlideModel* model, QWidget* parent = nullptr);

  /// Sets the line above the list.
  void setSummary(const QString& summary);

  const ContactSettings& settings() const { return settings_; }

 signals:
  /// The user chose a finding: its worst frame, and the joint or bone end that slides.
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
