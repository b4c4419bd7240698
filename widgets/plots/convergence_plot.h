// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

class QCustomPlot;
class QLabel;

namespace mocapress {

struct EncodeProgress;

/// Plots eps_x (cm) over the iterations of a running refinement. Earlier passes stay, faintly.
class ConvergencePlot : public QWidget {
  Q_OBJECT

 public:
  explicit ConvergencePlot(QWidget* parent = nullptr);

  void clear();
  void append(const std::vector<EncodeProgress>& states);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void startPass(int pass);

  QLabel* title_;
  QCustomPlot* plot_;
  int pass_ = -1;
};

}  // namespace mocapress
