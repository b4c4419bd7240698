// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/annealing_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/plots/convergence_plot.h"

namespace mocapress {
namespace {

constexpr int kProgressSteps = 1000;

}  // namespace

double passProgress(const EncodeProgress& state) {
  if (state.first_step <= 0) return 0;
  return 1 - std::log2(state.step + 1) / std::log2(state.first_step + 1);
}

AnnealingPanel::AnnealingPanel(QWidget* parent)
    : QWidget(parent),
      progress_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      pass_(new QLabel(this)),
      plot_(new ConvergencePlot(this)) {
  progress_->setAccessibleName(tr("Progress of the refinement"));
  progress_->setRange(0, kProgressSteps);
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  progress_->setToolTip(
      tr("The draft is refined: annealing moves fewer and fewer coefficients at a time, a closed "
         "loop sweeps over all of them, until nothing helps. Most targets take several passes."));
  cancel_->setToolTip(tr("Stop refining. The best so far is kept where it beats the draft."));
  cancel_->setEnabled(false);
  plot_->setMinimumHeight(110);

  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(progress_, 1);
  row->addWidget(pass_);
  row->addWidget(cancel_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addLayout(row);
  column->addWidget(plot_, 1);

  connect(cancel_, &QPushButton::clicked, this, &AnnealingPanel::cancelRequested);
  setRunning(false);
  progress_->setValue(0);
}

void AnnealingPanel::setRunning(bool running) {
  cancel_->setEnabled(running);
  progress_->setRange(0, kProgressSteps);
  if (!running) {
    if (!pass_->text().isEmpty()) progress_->setValue(kProgressSteps);
    return;
  }
  progress_->setValue(0);
  pass_->clear();
  plot_->clear();
}

void AnnealingPanel::append(const std::vector<EncodeProgress>& states) {
  if (states.empty()) return;
  const EncodeProgress& newest = states.back();
  // How many sweeps a closed loop takes is not known beforehand.
  progress_->setRange(0, newest.first_step > 0 ? kProgressSteps : 0);
  progress_->setValue(static_cast<int>(kProgressSteps * passProgress(newest)));
  pass_->setText(tr("Pass %1").arg(newest.pass + 1));
  plot_->append(states);
}

}  // namespace mocapress
