// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/convergence_plot.h"

#include <qcustomplot.h>

#include <QLabel>
#include <QVBoxLayout>

#include "core/codec/encode/encoder.h"
#include "widgets/plots/plot_style.h"

namespace mocapress {

ConvergencePlot::ConvergencePlot(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel(tr("Error while refining"), this)),
      plot_(new QCustomPlot(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(title_);
  column->addWidget(plot_, 1);
  offerCopyImage(this);
  plot_->setAccessibleName(title_->text());
  plot_->setToolTip(tr("Error after each iteration of the refinement."));
  plot_->xAxis->setLabel(tr("Iteration"));
  plot_->yAxis->setLabel(tr("eps_x (cm)"));
  plot_->xAxis->ticker()->setTickCount(4);
  plot_->yAxis->ticker()->setTickCount(3);
  applyPalette(plot_);
  clear();
}

/// Hides the plot, too: empty axes would suggest a range from 0 to 1.
void ConvergencePlot::clear() {
  plot_->clearGraphs();
  pass_ = -1;
  title_->hide();
  plot_->hide();
}

void ConvergencePlot::startPass(int pass) {
  pass_ = pass;
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.25F);
  for (int i = 0; i < plot_->graphCount(); ++i) plot_->graph(i)->setPen(QPen(faint, 1));
  plot_->addGraph()->setPen(QPen(palette().color(QPalette::Highlight), 1.6));
}

void ConvergencePlot::append(const std::vector<EncodeProgress>& states) {
  for (const EncodeProgress& state : states) {
    if (state.pass != pass_) startPass(state.pass);
    // A segment coded alone reports no error, since its error is not that of the whole clip.
    if (state.eps_cm > 0)
      plot_->graph(plot_->graphCount() - 1)->addData(state.iteration, state.eps_cm);
  }
  if (plot_->graphCount() == 0) return;
  title_->show();
  plot_->show();
  plot_->rescaleAxes();
  plot_->yAxis->scaleRange(1.1);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ConvergencePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  applyPalette(plot_);
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace mocapress
