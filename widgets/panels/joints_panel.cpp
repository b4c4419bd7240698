// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/joints_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QStyle>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/models/joint_error_model.h"

namespace mocapress {
namespace {

constexpr int kLeastNameLetters = 12;

/// A list with check boxes that takes the Space key, which would otherwise play and pause the clip.
/// The first column takes the remaining width, but stays readable.
class CheckList : public QTreeView {
 public:
  using QTreeView::QTreeView;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
      event->accept();
      return true;
    }
    return QTreeView::event(event);
  }
  void updateGeometries() override {
    int others = 0;
    for (int column = 1; column < header()->count(); ++column)
      others += header()->sectionSize(column);
    const int beside = style()->pixelMetric(QStyle::PM_IndicatorWidth, nullptr, this) +
                       iconSize().width() + 4 * style()->pixelMetric(QStyle::PM_FocusFrameHMargin);
    const int least = beside + kLeastNameLetters * fontMetrics().averageCharWidth();
    header()->resizeSection(0, std::max(least, viewport()->width() - others));
    QTreeView::updateGeometries();
  }
};

}  // namespace

JointsPanel::JointsPanel(JointErrorModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      sorted_(new QSortFilterProxyModel(this)),
      view_(new CheckList(this)) {
  sorted_->setSourceModel(model);
  sorted_->setSortRole(JointErrorModel::kSortRole);
  view_->setModel(sorted_);
  view_->setAccessibleName(tr("Joints"));
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAlternatingRowColors(true);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setIconSize({10, 10});
  view_->setSortingEnabled(true);
  view_->sortByColumn(JointErrorModel::Name, Qt::AscendingOrder);
  view_->header()->setStretchLastSection(false);
  view_->setTextElideMode(Qt::ElideMiddle);  // joint names often differ only at the end
  for (int column = JointErrorModel::Mean; column < JointErrorModel::kColumns; ++column)
    view_->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  const auto show_skin = [this] {
    view_->setColumnHidden(JointErrorModel::SkinMax, !model_->hasSkin());
  };
  connect(model, &QAbstractItemModel::modelReset, this, show_skin);
  connect(model, &QAbstractItemModel::dataChanged, this, show_skin);
  show_skin();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(view_);

  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            const QModelIndex source = sorted_->mapToSource(current);
            emit currentJointChanged(source.isValid() ? model_->jointOf(source.row()) : -1);
          });
}

void JointsPanel::setCurrentJoint(int joint) {
  const QModelIndex current = sorted_->mapToSource(view_->currentIndex());
  if (current.isValid() && model_->jointOf(current.row()) == joint) return;
  const QSignalBlocker blocker(view_->selectionModel());
  // Landmark j is the origin of joint j.
  const QModelIndex row = sorted_->mapFromSource(model_->index(joint, JointErrorModel::Name));
  view_->setCurrentIndex(row);
  view_->scrollTo(row);
  view_->viewport()->update();
}

}  // namespace mocapress
