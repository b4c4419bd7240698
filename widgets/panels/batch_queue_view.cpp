// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/batch_queue_view.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QHeaderView>
#include <QMimeData>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/models/batch_queue_model.h"
#include "widgets/models/colours.h"

namespace mocapress {
namespace {

constexpr int kQueueRowHeight = 28;

/// Draws a clip's state as text on a progress bar.
class StateDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const QVariant fraction = index.data(BatchQueueModel::kProgressRole);
    if (fraction.isValid()) paintBar(painter, option, fraction.toDouble());
    QStyledItemDelegate::paint(painter, option, index);
  }

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto state =
        static_cast<QueuedClip::State>(index.data(BatchQueueModel::kStateRole).toInt());
    option->textElideMode = Qt::ElideRight;
    if (state == QueuedClip::State::Waiting)
      option->palette.setColor(QPalette::Text, option->palette.color(QPalette::PlaceholderText));
    if (state == QueuedClip::State::Done)
      option->palette.setColor(QPalette::Text, QColor::fromRgb(kCurveColours[2]));
    if (state == QueuedClip::State::Failed)
      option->palette.setColor(QPalette::Text, QColor::fromRgb(kCurveColours[1]));
  }

 private:
  static void paintBar(QPainter* painter, const QStyleOptionViewItem& option, double fraction) {
    QRectF bar = QRectF(option.rect).adjusted(1, 4, -6, -4);
    QColor colour = option.palette.color(QPalette::Highlight);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    colour.setAlphaF(0.14F);
    painter->setBrush(colour);
    painter->drawRoundedRect(bar, 4, 4);
    bar.setWidth(std::max(8.0, bar.width() * std::clamp(fraction, 0.0, 1.0)));
    colour.setAlphaF(0.38F);
    painter->setBrush(colour);
    painter->drawRoundedRect(bar, 4, 4);
    painter->restore();
  }
};

/// Gives rows a comfortable height in every style.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    size.setHeight(std::max(size.height(), kQueueRowHeight));
    return size;
  }
};

QStringList localPaths(const QMimeData* data) {
  QStringList paths;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  return paths;
}

}  // namespace

BatchQueueView::BatchQueueView(BatchQueueModel* model, QWidget* parent) : QTreeView(parent) {
  setModel(model);
  setAccessibleName(tr("Clips of the batch"));
  setItemDelegate(new RowDelegate(this));
  setItemDelegateForColumn(BatchQueueModel::State, new StateDelegate(this));
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setAllColumnsShowFocus(true);
  setAlternatingRowColors(true);
  setSelectionMode(ExtendedSelection);
  setAcceptDrops(true);
  setFrameShape(NoFrame);
  QHeaderView* heads = header();
  heads->setStretchLastSection(false);
  heads->setMinimumSectionSize(30);
  constexpr int kWidths[] = {160, 32, 280, 100, 200, 76, 80, 76};
  for (int column = 0; column < BatchQueueModel::Columns; ++column)
    heads->resizeSection(column, kWidths[column]);
  heads->setSectionResizeMode(BatchQueueModel::State, QHeaderView::Stretch);
  heads->setSectionResizeMode(BatchQueueModel::Lock, QHeaderView::Fixed);

  connect(model, &BatchQueueModel::modelReset, this, &BatchQueueView::fitColumns);
  connect(model, &BatchQueueModel::rowsInserted, this, &BatchQueueView::fitColumns);
  connect(model, &BatchQueueModel::rowsRemoved, this, &BatchQueueView::fitColumns);
  connect(model, &BatchQueueModel::dataChanged, this, &BatchQueueView::fitColumns);
  fitColumns();
  auto* remove = new QAction(tr("Remove from Queue"), this);
  remove->setShortcut(QKeySequence::Delete);
  remove->setShortcutContext(Qt::WidgetShortcut);
  addAction(remove);
  setContextMenuPolicy(Qt::ActionsContextMenu);
  connect(remove, &QAction::triggered, this, [this] {
    if (editable_ && !selectedRows().empty()) emit removeRequested(selectedRows());
  });
  auto* leave_out = new QAction(tr("Leave Out"), this);
  auto* include = new QAction(tr("Export Too"), this);
  addActions({include, leave_out});
  connect(include, &QAction::triggered, this, [this] { requestLeftOut(false); });
  connect(leave_out, &QAction::triggered, this, [this] { requestLeftOut(true); });
  connect(model, &BatchQueueModel::includeToggled, this, [this](int row, bool included) {
    if (editable_) emit leaveOutRequested({row}, !included);
  });
  connect(this, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (editable_ && index.column() == BatchQueueModel::Lock) emit lockToggled(index.row());
  });
  connect(this, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
    if (index.column() != BatchQueueModel::Lock) emit openRequested(index.row());
  });
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &BatchQueueView::selectedRowsChanged);
}

/// Hides the verdict column while it is empty, so that the other columns have room.
void BatchQueueView::fitColumns() {
  const auto* queue = static_cast<const BatchQueueModel*>(model());
  const bool any = std::any_of(queue->clips().begin(), queue->clips().end(), [](const auto& clip) {
    return clip.review.verdict != Verdict::None || !clip.review.note.empty();
  });
  setColumnHidden(BatchQueueModel::Review, !any);
}

void BatchQueueView::requestLeftOut(bool left_out) {
  if (editable_ && !selectedRows().empty()) emit leaveOutRequested(selectedRows(), left_out);
}

std::vector<int> BatchQueueView::selectedRows() const {
  std::vector<int> rows;
  for (const QModelIndex& index : selectionModel()->selectedRows()) rows.push_back(index.row());
  std::sort(rows.begin(), rows.end());
  return rows;
}

void BatchQueueView::dragEnterEvent(QDragEnterEvent* event) {
  if (editable_ && event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void BatchQueueView::dragMoveEvent(QDragMoveEvent* event) {
  if (editable_ && event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void BatchQueueView::dropEvent(QDropEvent* event) {
  const QStringList paths = localPaths(event->mimeData());
  if (!editable_ || paths.isEmpty()) return;
  event->acceptProposedAction();
  emit dropped(paths);
}

/// Draws a hint while the queue is empty.
void BatchQueueView::paintEvent(QPaintEvent* event) {
  QTreeView::paintEvent(event);
  if (model()->rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setRenderHint(QPainter::Antialiasing);
  QColor line = palette().color(QPalette::PlaceholderText);
  painter.setPen(line);
  QFont font = this->font();
  font.setPointSizeF(1.3 * font.pointSizeF());
  painter.setFont(font);
  const QRect whole = viewport()->rect();
  painter.drawText(whole.adjusted(0, 0, 0, -14), Qt::AlignCenter,
                   tr("Drop clips or folders of clips here"));
  painter.setFont(this->font());
  painter.drawText(whole.adjusted(0, 44, 0, 0), Qt::AlignCenter,
                   tr("The .asf beside an .amc is found"));
  line.setAlphaF(0.5F);
  painter.setPen(QPen(line, 1.5, Qt::DashLine));
  painter.drawRoundedRect(QRectF(whole).adjusted(24, 24, -24, -24), 12, 12);
}

}  // namespace mocapress
