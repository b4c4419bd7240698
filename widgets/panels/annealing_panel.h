// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/codec/encoder.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace mocapress {

class ConvergencePlot;

/// A running refinement, by annealing or in a closed loop: how far it is, how the error falls, and
/// a way out.
class AnnealingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AnnealingPanel(QWidget* parent = nullptr);

  /// true: a new refinement begins, the old curve goes. false: it ended, the curve stays.
  void setRunning(bool running);

  void append(const std::vector<EncodeProgress>& states);

 signals:
  void cancelRequested();

 private:
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* pass_;
  ConvergencePlot* plot_;
};

/// Share done of a pass, 0 to 1: the step halves from first_step until it is 0.
double passProgress(const EncodeProgress& state);

}  // namespace mocapress
