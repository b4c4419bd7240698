// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/pinned_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/models/pinned_model.h"

namespace mocapress {
namespace {

constexpr int kLeastName = 90;  // px

}  // namespace

PinnedPanel::PinnedPanel(PinnedModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      view_(new QTreeView(this)),
      pin_(new QPushButton(tr("Pin This"), this)),
      make_current_(new QPushButton(tr("Make Current"), this)),
      unpin_(new QPushButton(tr("Unpin"), this)) {
  view_->setModel(model);
  view_->setAccessibleName(tr("Pinned results"));
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAlternatingRowColors(true);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setIconSize({10, 10});
  view_->header()->setStretchLastSection(false);
  view_->header()->setMinimumSectionSize(40);
  view_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->header()->setSectionResizeMode(PinnedModel::Name, QHeaderView::Fixed);
  view_->viewport()->installEventFilter(this);
  connect(view_->header(), &QHeaderView::sectionResized, this, [this](int column) {
    if (column != PinnedModel::Name) fitNames();
  });
  pin_->setToolTip(
      tr("Keep the current result in the view, as a figure with its own colour, while you try "
         "other settings."));
  make_current_->setToolTip(tr("Use the settings of the selected result. This can be undone."));
  unpin_->setToolTip(tr("Remove the selected result from the view."));

  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {pin_, make_current_, unpin_}) buttons->addWidget(button, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 0, 8, 6);
  column->setSpacing(6);
  column->addWidget(view_, 1);
  column->addLayout(buttons);

  connect(pin_, &QPushButton::clicked, this, &PinnedPanel::pinRequested);
  connect(make_current_, &QPushButton::clicked, this,
          [this] { emit makeCurrentRequested(current()); });
  connect(unpin_, &QPushButton::clicked, this, [this] { emit unpinRequested(current()); });
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          &PinnedPanel::showChosen);
  connect(model, &PinnedModel::modelReset, this, [this] {
    const int last = model_->rowCount() - 1;
    if (last >= 0) view_->setCurrentIndex(model_->index(last, 0));
    showChosen();
  });
  setCanPin(false);
  showChosen();
}

bool PinnedPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::Resize) fitNames();
  return QWidget::eventFilter(watched, event);
}

/// Gives the names all free width. If less than kLeastName is free, they get that, and the columns
/// scroll.
void PinnedPanel::fitNames() {
  QHeaderView* header = view_->header();
  const int others = header->length() - header->sectionSize(PinnedModel::Name);
  const int room = view_->viewport()->width() - others;
  header->resizeSection(PinnedModel::Name, std::max(kLeastName, room));
}

int PinnedPanel::current() const {
  return view_->currentIndex().isValid() ? view_->currentIndex().row() : -1;
}

void PinnedPanel::setCanPin(bool can) {
  pin_->setEnabled(can);
}

void PinnedPanel::showChosen() {
  for (QPushButton* button : {make_current_, unpin_}) button->setEnabled(current() >= 0);
}

}  // namespace mocapress
