// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/library_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include "widgets/models/library_model.h"

namespace mocapress {
namespace {

constexpr int kRowHeight = 58;
constexpr int kPicture = 46;
constexpr int kMargin = 6;

/// A pose, the name, what it came to and what was decided.
class RowPainter : public QStyledItemDelegate {
 public:
  RowPainter(const LibraryModel* model, QObject* parent)
      : QStyledItemDelegate(parent), model_(model) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
    return {120, kRowHeight};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const LibraryEntry& entry = model_->entry(index.row());
    const bool chosen = option.state & QStyle::State_Selected;
    const QPalette& palette = option.palette;
    painter->save();
    painter->setClipRect(option.rect);
    if (chosen) painter->fillRect(option.rect, palette.brush(QPalette::Highlight));
    const QColor text = palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
    QColor faint = text;
    faint.setAlphaF(0.65F);
    const QRect picture(option.rect.left() + kMargin, option.rect.center().y() - kPicture / 2,
                        kPicture, kPicture);
    paintPose(*painter, entry, picture, text);

    QRect line(picture.right() + 2 * kMargin, option.rect.top() + kMargin,
               option.rect.right() - picture.right() - 3 * kMargin, option.fontMetrics.height());
    const auto write = [&](const QString& words, const QColor& colour, const QFont& font) {
      painter->setPen(colour);
      painter->setFont(font);
      painter->drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                        QFontMetrics(font).elidedText(words, Qt::ElideMiddle, line.width()));
      line.translate(0, option.fontMetrics.height());
    };
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    write(index.data().toString(), text, bold);
    write(outcomeText(entry), text, option.font);
    write(stateText(entry), faint, option.font);
    painter->restore();
  }

 private:
  static void paintPose(QPainter& painter, const LibraryEntry& entry, const QRect& place,
                        const QColor& colour) {
    painter.setRenderHint(QPainter::Antialiasing);
    QColor plate = colour;
    plate.setAlphaF(0.07F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(place, 3, 3);
    painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap));
    const QRect inner = place.adjusted(3, 3, -3, -3);
    const auto at = [&](const QPointF& point) {
      return QPointF(inner.left() + point.x() * inner.width(),
                     inner.top() + point.y() * inner.height());
    };
    for (const QLineF& bone : entry.outline) painter.drawLine(at(bone.p1()), at(bone.p2()));
  }

  const LibraryModel* model_;
};

}  // namespace

LibraryPanel::LibraryPanel(LibraryModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      list_(new QListView(this)),
      add_(new QPushButton(tr("Add Clips…"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      verdict_(new QComboBox(this)),
      note_(new QLineEdit(this)) {
  list_->setModel(model);
  list_->setItemDelegate(new RowPainter(model, list_));
  list_->setUniformItemSizes(true);
  list_->setFrameShape(QFrame::NoFrame);
  list_->setAccessibleName(tr("Clips of the project"));
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(list_, &QWidget::customContextMenuRequested, this, &LibraryPanel::showMenu);
  add_->setToolTip(tr("Add motion files to the project. Each keeps its own settings."));
  remove_->setToolTip(tr("Take the clip out of the project; its file stays."));
  verdict_->setAccessibleName(tr("Verdict"));
  verdict_->setToolTip(tr("What quality assurance says about the clip as it is compressed now."));
  verdict_->addItem(tr("Not reviewed"), static_cast<int>(Verdict::None));
  verdict_->addItem(tr("Approved"), static_cast<int>(Verdict::Approved));
  verdict_->addItem(tr("Rejected"), static_cast<int>(Verdict::Rejected));
  note_->setAccessibleName(tr("Note"));
  note_->setPlaceholderText(tr("Note about this clip"));
  note_->setToolTip(tr("Kept in the project, with the verdict."));
  note_->setClearButtonEnabled(true);

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_, 1);
  buttons->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(6);
  column->addWidget(list_, 1);
  auto* below = new QVBoxLayout;
  below->setContentsMargins(8, 0, 8, 0);
  below->addWidget(verdict_);
  below->addWidget(note_);
  below->addLayout(buttons);
  column->addLayout(below);

  connect(add_, &QPushButton::clicked, this, &LibraryPanel::addRequested);
  connect(remove_, &QPushButton::clicked, this, [this] { emit removeRequested(current()); });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& index) {
            showReview();
            if (index.isValid()) emit openRequested(index.row());
          });
  connect(verdict_, &QComboBox::activated, this, [this] {
    emit verdictChosen(current(), static_cast<Verdict>(verdict_->currentData().toInt()));
  });
  connect(note_, &QLineEdit::textEdited, this,
          [this](const QString& note) { emit noteEdited(current(), note); });
  for (const auto changed : {&LibraryModel::modelReset})
    connect(model, changed, this, &LibraryPanel::showReview);
  showReview();
}

void LibraryPanel::showMenu(const QPoint& place) {
  std::vector<int> rows;
  for (const QModelIndex& index : list_->selectionModel()->selectedIndexes())
    rows.push_back(index.row());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* selected = menu->addAction(tr("Export Selected, Each by Its Own Settings…"));
  selected->setEnabled(!rows.empty());
  connect(selected, &QAction::triggered, this, [this, rows] { emit exportRequested(rows); });
  QAction* all = menu->addAction(tr("Export All, Each by Its Own Settings…"));
  all->setEnabled(model_->rowCount() > 0);
  connect(all, &QAction::triggered, this, [this] { emit exportRequested({}); });
  menu->popup(list_->viewport()->mapToGlobal(place));
}

int LibraryPanel::current() const {
  return list_->currentIndex().isValid() ? list_->currentIndex().row() : -1;
}

void LibraryPanel::setCurrent(int row) {
  {
    const QSignalBlocker blocker(list_->selectionModel());
    list_->setCurrentIndex(model_->index(row));
    list_->scrollTo(model_->index(row));
  }
  list_->viewport()->update();
  showReview();
}

void LibraryPanel::showReview() {
  const int row = current();
  for (QWidget* each : {static_cast<QWidget*>(verdict_), static_cast<QWidget*>(note_),
                        static_cast<QWidget*>(remove_)})
    each->setEnabled(row >= 0);
  const LibraryEntry shown = row >= 0 ? model_->entry(row) : LibraryEntry();
  verdict_->setCurrentIndex(verdict_->findData(static_cast<int>(shown.verdict)));
  if (note_->text() != shown.note) note_->setText(shown.note);
}

}  // namespace mocapress
