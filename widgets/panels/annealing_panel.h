// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "widgets/models/encode_estimate.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace mocapress {

class ConvergencePlot;

/// Shows a running refinement, by annealing or in a closed loop: its progress, the remaining time,
/// the falling error, and a button to stop it.
class AnnealingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AnnealingPanel(QWidget* parent = nullptr);

  /// Waits for the next refinement and clears the old curve.
  void await();

  /// Starts showing a refinement with these options.
  void begin(const EncodeSettings& options);

  void append(const std::vector<EncodeProgress>& states);

  /// The refinement ended. Its curve stays. Does nothing while the next refinement is awaited.
  void end();

  /// Stops waiting.
  void rest();

 signals:
  void cancelRequested();

 private:
  enum class State { Idle, Waiting, Running };
  void setState(State state);

  State state_ = State::Idle;
  EncodeEstimate estimate_{{}};
  QElapsedTimer clock_;
  QTimer slow_;  // delay before the bar shows that something is on its way
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* left_;
  ConvergencePlot* plot_;
};

}  // namespace mocapress
