// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/bytes_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStyledItemDelegate>
#include <QTreeView>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/models/byte_cost_model.h"

namespace mocapress {
namespace {

constexpr int kRoomForShares = 520;

/// Draws a bar behind each share, relative to the largest share.
class BarDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    double most = 1;
    const QAbstractItemModel& model = *index.model();
    for (int row = 0; row < model.rowCount(); ++row)
      most = std::max(most,
                      model.index(row, index.column()).data(ByteCostModel::kSortRole).toDouble());
    const double share = index.data(ByteCostModel::kSortRole).toDouble() / most;
    QColor colour = option.palette.color(QPalette::Highlight);
    colour.setAlphaF(0.3F);
    QRectF bar = QRectF(option.rect).adjusted(2, 2, -2, -2);
    bar.setWidth(std::max(0.0, share) * bar.width());
    painter->fillRect(bar, colour);
  }
};

}  // namespace

BytesPanel::BytesPanel(ByteCostModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      sorted_(new QSortFilterProxyModel(this)),
      view_(new QTreeView(this)) {
  sorted_->setSourceModel(model);
  sorted_->setSortRole(ByteCostModel::kSortRole);
  view_->setModel(sorted_);
  view_->setAccessibleName(tr("Bytes by joint"));
  view_->setRootIsDecorated(false);
  view_->setUniformRowHeights(true);
  view_->setAlternatingRowColors(true);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setSortingEnabled(true);
  view_->sortByColumn(ByteCostModel::Bytes, Qt::DescendingOrder);
  view_->setItemDelegateForColumn(ByteCostModel::Share, new BarDelegate(this));
  // The names shrink first: the numbers are what the table is about.
  view_->header()->setStretchLastSection(false);
  view_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  view_->header()->setSectionResizeMode(ByteCostModel::Name, QHeaderView::Stretch);
  auto* halves = new QSplitter(this);
  halves->addWidget(view_);
  halves->addWidget(makeSlopes());
  halves->setStretchFactor(0, 2);
  halves->setStretchFactor(1, 3);
  halves->setSizes({160, 240});  // room for names in a window of 1280
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(halves);
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& current) {
            const QModelIndex source = sorted_->mapToSource(current);
            if (source.isValid() && model_->jointOf(source.row()) >= 0)
              emit currentJointChanged(model_->jointOf(source.row()));
          });
  setState(false, false);
}

/// Hides the shares where names would lack room.
void BytesPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  view_->setColumnHidden(ByteCostModel::Share, width() < kRoomForShares);
}

QWidget* BytesPanel::makeSlopes() {
  auto* half = new QWidget(this);
  slopes_ = new QTreeWidget(half);
  slopes_->setAccessibleName(tr("Other settings, tried"));
  slopes_->setRootIsDecorated(false);
  slopes_->setAlternatingRowColors(true);
  slopes_->setFrameShape(QFrame::NoFrame);
  slopes_->setHeaderLabels({tr("Change"), tr("Bytes"), tr("Its error")});
  slopes_->header()->setStretchLastSection(false);
  slopes_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  slopes_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  hint_ =
      new QLabel(tr("See what it saves to be less exact in one place, or what more bytes bring. "
                    "Each line is a real encode."),
                 half);
  hint_->setWordWrap(true);
  measure_ = new QPushButton(tr("Try Other Settings"), half);
  apply_ = new QPushButton(tr("Use These"), half);
  apply_->setEnabled(false);
  apply_->setToolTip(tr("Compress with the settings of the chosen line; can be undone"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(measure_);
  buttons->addStretch();
  buttons->addWidget(apply_);
  auto* column = new QVBoxLayout(half);
  column->setContentsMargins(8, 0, 8, 6);
  column->addWidget(hint_);
  column->addWidget(slopes_, 1);
  column->addLayout(buttons);
  connect(measure_, &QPushButton::clicked, this, &BytesPanel::measureRequested);
  const auto use = [this] {
    const int row = slopes_->indexOfTopLevelItem(slopes_->currentItem());
    if (row >= 0) emit applyRequested(row);
  };
  connect(apply_, &QPushButton::clicked, this, use);
  connect(slopes_, &QTreeWidget::itemActivated, this, use);
  connect(slopes_, &QTreeWidget::currentItemChanged, this,
          [this](const QTreeWidgetItem* item) { apply_->setEnabled(item != nullptr); });
  return half;
}

void BytesPanel::setCurrentJoint(int joint) {
  const QSignalBlocker blocker(view_->selectionModel());
  const QModelIndex row = joint < 0 || joint >= model_->rowCount()
                              ? QModelIndex()
                              : sorted_->mapFromSource(model_->index(joint, ByteCostModel::Name));
  view_->setCurrentIndex(row);
  if (row.isValid()) view_->scrollTo(row);
  view_->viewport()->update();
}

void BytesPanel::setSlopes(const std::vector<SlopeRow>& slopes) {
  const int chosen = slopes_->indexOfTopLevelItem(slopes_->currentItem());
  slopes_->clear();
  for (const SlopeRow& slope : slopes) {
    const QString sign = slope.bytes > 0 ? QStringLiteral("+") : QString();
    auto* item = new QTreeWidgetItem(
        slopes_, {slope.change, sign + QStringLiteral("%L1").arg(slope.bytes, 0, 'f', 0),
                  tr("%L1 → %L2 mm")
                      .arg(10 * slope.error_cm, 0, 'f', 1)
                      .arg(10 * slope.becomes_cm, 0, 'f', 1)});
    item->setToolTip(0, slope.change);
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
  }
  hint_->setVisible(slopes.empty());
  slopes_->setCurrentItem(slopes_->topLevelItem(chosen));  // null: no line is current
  apply_->setEnabled(slopes_->currentItem() != nullptr);
}

void BytesPanel::setState(bool measuring, bool possible) {
  measure_->setEnabled(possible && !measuring);
  measure_->setText(measuring ? tr("Trying…") : tr("Try Other Settings"));
}

}  // namespace mocapress
