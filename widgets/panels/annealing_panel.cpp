// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/annealing_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <chrono>
#include <cmath>

#include "core/codec/encode/encoder.h"
#include "widgets/plots/convergence_plot.h"

namespace mocapress {
namespace {

constexpr int kProgressSteps = 1000;
constexpr std::chrono::milliseconds kSlow{300};

/// Formats the remaining time as "8 s left" or "2 min left": the estimate is not more precise.
QString timeLeft(double seconds) {
  if (seconds < 60) {
    const int step = seconds < 10 ? 1 : 5;
    return AnnealingPanel::tr("%L1 s left").arg(step * std::max(1, qRound(seconds / step)));
  }
  return AnnealingPanel::tr("%L1 min left").arg(qRound(seconds / 60));
}

}  // namespace

AnnealingPanel::AnnealingPanel(QWidget* parent)
    : QWidget(parent),
      progress_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      left_(new QLabel(this)),
      plot_(new ConvergencePlot(this)) {
  progress_->setAccessibleName(tr("Progress of the refinement"));
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  progress_->setToolTip(
      tr("Progress of refining the draft. Annealing moves fewer and fewer coefficients at a time; "
         "the closed loop sweeps over all coefficients until no change helps. Most targets need "
         "several passes, whose number is an estimate."));
  left_->setAccessibleName(tr("Time left"));
  cancel_->setToolTip(
      tr("Stop refining. The best result so far is kept if it is better than the draft."));
  plot_->setMinimumHeight(130);
  // Hidden widgets keep their room, so that nothing moves when they appear.
  for (QWidget* each : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(left_)}) {
    QSizePolicy policy = each->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    each->setSizePolicy(policy);
  }

  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(progress_, 1);
  row->addWidget(left_);
  row->addWidget(cancel_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addLayout(row);
  column->addWidget(plot_, 1);

  slow_.setSingleShot(true);
  slow_.setInterval(kSlow);
  connect(&slow_, &QTimer::timeout, this, [this] {
    progress_->setRange(0, 0);  // a busy indicator: the duration of a draft is unknown
    progress_->show();
  });
  connect(cancel_, &QPushButton::clicked, this, &AnnealingPanel::cancelRequested);
  setState(State::Idle);
}

void AnnealingPanel::setState(State state) {
  state_ = state;
  slow_.stop();
  if (state == State::Waiting) slow_.start();
  cancel_->setEnabled(state == State::Running);
  progress_->setVisible(state == State::Running);
  progress_->setRange(0, kProgressSteps);
  progress_->setValue(0);
  left_->clear();
}

void AnnealingPanel::await() {
  plot_->clear();
  setState(State::Waiting);
}

void AnnealingPanel::begin(const EncodeSettings& options) {
  plot_->clear();
  estimate_ = EncodeEstimate(options);
  clock_.start();
  setState(State::Running);
}

void AnnealingPanel::end() {
  if (state_ == State::Running) setState(State::Idle);
}

void AnnealingPanel::rest() {
  setState(State::Idle);
}

void AnnealingPanel::append(const std::vector<EncodeProgress>& states) {
  if (states.empty() || state_ != State::Running) return;
  for (const EncodeProgress& state : states)
    estimate_.add(state, 1e-9 * static_cast<double>(clock_.nsecsElapsed()));
  progress_->setValue(static_cast<int>(kProgressSteps * estimate_.share()));
  const std::optional<double> left = estimate_.secondsLeft();
  left_->setText(left ? timeLeft(*left) : QString());
  plot_->append(states);
}

}  // namespace mocapress
