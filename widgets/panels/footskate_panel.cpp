// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/footskate_panel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include "widgets/models/slide_model.h"

namespace mocapress {

FootskatePanel::FootskatePanel(SlideModel* model, QWidget* parent)
    : QWidget(parent), summary_(new QLabel(this)), view_(new QTreeView(this)) {
  summary_->setWordWrap(true);
  view_->setModel(model);
  view_->setAccessibleName(tr("Findings of footskate"));
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAlternatingRowColors(true);
  view_->setFrameShape(QFrame::NoFrame);
  view_->header()->setStretchLastSection(false);
  view_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->header()->setSectionResizeMode(SlideModel::Joint, QHeaderView::Stretch);

  auto* thresholds = new QGridLayout;
  thresholds->setHorizontalSpacing(6);
  thresholds->setVerticalSpacing(3);
  const auto add_caption = [&](const QString& text, int row, int column) {
    thresholds->addWidget(new QLabel(text, this), row, column);
  };
  add_caption(tr("Contact"), 0, 0);
  add_caption(tr("begins below"), 0, 1);
  add_caption(tr("ends above"), 0, 2);
  add_caption(tr("Height"), 1, 0);
  add_caption(tr("Speed"), 2, 0);
  addThreshold(thresholds, 1, 1, &settings_.begin_height, tr(" cm"),
               tr("Height below which a contact begins"));
  addThreshold(thresholds, 1, 2, &settings_.end_height, tr(" cm"),
               tr("Height above which a contact ends"));
  addThreshold(thresholds, 2, 1, &settings_.begin_speed, tr(" cm/s"),
               tr("Speed below which a contact begins"));
  addThreshold(thresholds, 2, 2, &settings_.end_speed, tr(" cm/s"),
               tr("Speed above which a contact ends"));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 0, 8, 6);
  column->setSpacing(6);
  column->addWidget(summary_);
  column->addWidget(view_, 1);
  column->addLayout(thresholds);

  const auto choose = [this, model](const QModelIndex& index) {
    if (!index.isValid()) return;
    const SlideFinding& finding = model->finding(index.row());
    emit findingChosen(finding.worst_frame, finding.span.landmark);
  };
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, choose);
  connect(view_, &QTreeView::clicked, this, choose);  // clicking the current row seeks again
}

void FootskatePanel::addThreshold(QGridLayout* grid, int row, int column, double* value,
                                  const QString& unit, const QString& name) {
  auto* box = new QDoubleSpinBox(this);
  box->setRange(0.1, 500);
  box->setDecimals(1);
  box->setSuffix(unit);
  box->setKeyboardTracking(false);
  box->setAccessibleName(name);
  box->setToolTip(tr("%1, measured in the original.").arg(name));
  box->setValue(*value);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, value](double chosen) {
    *value = chosen;
    emit settingsChanged(settings_);
  });
  grid->addWidget(box, row, column);
}

void FootskatePanel::setSummary(const QString& summary) {
  summary_->setText(summary);
}

}  // namespace mocapress
