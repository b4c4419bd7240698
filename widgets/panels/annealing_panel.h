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

/// A running refinement, by annealing or in a closed loop: how far it is and how long it will take,
/// how the error falls, and a way out.
class AnnealingPanel : public QWidget {
  Q_OBJECT

 public:
  explicit AnnealingPanel(QWidget* parent = nullptr);

  /// Something new was asked for: the curve of what was before goes.
  void await();

  /// A refinement by these options begins.
  void begin(const EncodeSettings& options);

  void append(const std::vector<EncodeProgress>& states);

  /// The refinement ended, the curve stays. Nothing happens where something new is awaited.
  void end();

  /// Nothing is awaited any more.
  void rest();

 signals:
  void cancelRequested();

 private:
  enum class State { Idle, Waiting, Running };
  void setState(State state);

  State state_ = State::Idle;
  EncodeEstimate estimate_{{}};
  QElapsedTimer clock_;
  QTimer slow_;  // an answer that takes longer is said to be on its way
  QProgressBar* progress_;
  QPushButton* cancel_;
  QLabel* left_;
  ConvergencePlot* plot_;
};

}  // namespace mocapress
