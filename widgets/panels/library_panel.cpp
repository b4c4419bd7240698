// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/library_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTextDocument>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <algorithm>

#include "widgets/models/display_names.h"
#include "widgets/models/library_columns.h"
#include "widgets/models/library_model.h"
#include "widgets/models/library_tree.h"
#include "widgets/models/sentence.h"
#include "widgets/panels/elided_label.h"
#include "widgets/panels/encoding_bar.h"
#include "widgets/panels/review_bar.h"

namespace mocapress {
namespace {

constexpr int kRowHeight = 58;
constexpr int kPicture = 46;
constexpr int kFolderHeight = 28;
constexpr int kMargin = 6;
constexpr int kColumnWidth = 10;            // characters
constexpr int kRoomyColumns = 2;            // columns that fit into the minimum width
constexpr int kClipWidth = 180;             // least width of the clips beside other columns
const QString kMark = QStringLiteral("⚠");  // there are notes on the clip
const QString kPen = QStringLiteral("✎");   // a reviewer has written something

/// Shows the notes on a clip, such as repairs by its reader, until a click or key.
void showNotes(const LibraryEntry& entry, const QPoint& place) {
  QStringList lines;
  for (const QString& note : notesOf(entry)) lines << translatedSentence(note);
  if (!lines.isEmpty())
    QWhatsThis::showText(place, Qt::convertFromPlainText(lines.join(QLatin1Char('\n'))));
}

/// Draws a clip's pose, name, result and verdict, and a folder's summary.
class RowPainter : public QStyledItemDelegate {
 public:
  RowPainter(const LibraryModel* model, const LibraryTree* tree, QObject* parent)
      : QStyledItemDelegate(parent), model_(model), tree_(tree) {}

  QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const override {
    return {120, tree_->clipOf(index) < 0 ? kFolderHeight : kRowHeight};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const int clip = tree_->clipOf(index);
    if (clip < 0) return paintFolder(*painter, option, index);
    const LibraryEntry& entry = model_->entry(clip);
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
                        QFontMetrics(font).elidedText(words, Qt::ElideRight, line.width()));
      line.translate(0, option.fontMetrics.height());
    };
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    const bool has_notes = !notesOf(entry).isEmpty();
    if (has_notes) {
      painter->setPen(chosen ? text : colourOf(RowState::Doubtful, palette));
      painter->drawText(markOf(option), Qt::AlignCenter, kMark);
    }
    const bool has_review = !entry.review.note.empty() || !entry.review.notes.empty();
    if (has_review) {
      painter->setPen(text);
      painter->drawText(markOf(option).translated(has_notes ? -markOf(option).width() : 0, 0),
                        Qt::AlignCenter, kPen);
    }
    const int marks = (has_notes ? 1 : 0) + (has_review ? 1 : 0);
    const int room = line.width() - marks * markOf(option).width();
    write(shortened(index.data().toString(), tree_->sharedNameOf(index), QFontMetrics(bold), room),
          entry.missing ? faint : text, bold);
    write(outcomeText(entry), entry.outdated == Staleness::None ? text : faint, option.font);
    const RowState state = stateOf(entry);
    write(stateText(entry), chosen || state == RowState::Plain ? faint : colourOf(state, palette),
          option.font);
    painter->restore();
  }

  /// Shows the notes when their mark is clicked.
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override {
    const int clip = tree_->clipOf(index);
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    if (clip >= 0 && mouse && event->type() == QEvent::MouseButtonRelease &&
        markOf(option).contains(mouse->pos()))
      showNotes(model_->entry(clip), mouse->globalPosition().toPoint());
    return QStyledItemDelegate::editorEvent(event, model, option, index);
  }

 private:
  /// The place of the mark, at the end of a row's first line.
  static QRect markOf(const QStyleOptionViewItem& option) {
    const int size = option.fontMetrics.height();
    return {option.rect.right() - kMargin - size, option.rect.top() + kMargin, size, size};
  }

  void paintFolder(QPainter& painter, const QStyleOptionViewItem& option,
                   const QModelIndex& index) const {
    const bool chosen = option.state & QStyle::State_Selected;
    const QPalette& palette = option.palette;
    painter.save();
    if (chosen) painter.fillRect(option.rect, palette.brush(QPalette::Highlight));
    const QColor text = palette.color(chosen ? QPalette::HighlightedText : QPalette::Text);
    QColor faint = text;
    faint.setAlphaF(0.65F);
    QFont bold = option.font;
    bold.setWeight(QFont::DemiBold);
    const QRect line = option.rect.adjusted(kMargin / 2, 0, -kMargin, 0);
    const QString summary = tree_->folderSummary(index);
    const int taken = option.fontMetrics.horizontalAdvance(summary) + kMargin;
    painter.setPen(faint);
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, summary);
    painter.setPen(text);
    painter.setFont(bold);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(bold).elidedText(index.data().toString(), Qt::ElideMiddle,
                                                   line.width() - taken));
    painter.restore();
  }

  static void paintPose(QPainter& painter, const LibraryEntry& entry, const QRect& place,
                        const QColor& colour) {
    painter.setRenderHint(QPainter::Antialiasing);
    QColor plate = colour;
    plate.setAlphaF(0.07F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(plate);
    painter.drawRoundedRect(place, 3, 3);
    if (!entry.skin.isNull()) {
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
      return painter.drawImage(place.adjusted(2, 2, -2, -2), entry.skin);
    }
    painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap));
    const QRect inner = place.adjusted(3, 3, -3, -3);
    const auto at = [&](const QPointF& point) {
      return QPointF(inner.left() + point.x() * inner.width(),
                     inner.top() + point.y() * inner.height());
    };
    for (const QLineF& bone : entry.outline) painter.drawLine(at(bone.p1()), at(bone.p2()));
  }

  const LibraryModel* model_;
  const LibraryTree* tree_;
};

}  // namespace

LibraryPanel::LibraryPanel(LibraryModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      tree_(new LibraryTree(model, this)),
      filter_(new QLineEdit(this)),
      shown_(new QComboBox(this)),
      grouping_(new QComboBox(this)),
      view_(new QTreeView(this)),
      sum_(new ElidedLabel(this)),
      encoding_(new EncodingBar(model, this)),
      reviewed_(new ReviewBar(model, this)),
      add_(new QPushButton(tr("Add"), this)),
      remove_(new QPushButton(tr("Remove"), this)),
      verdict_(new QComboBox(this)),
      note_(new QLineEdit(this)) {
  filter_->setAccessibleName(tr("Filter of the clips"));
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setToolTip(
      tr("Words in a clip's name, folder or state, such as “walks missed”, and bounds on columns, "
         "such as “error>=5mm ratio<20”: lengths without a unit are in cm."));
  filter_->setClearButtonEnabled(true);
  view_->setModel(tree_);
  view_->setItemDelegateForColumn(0, new RowPainter(model, tree_, view_));
  view_->setAllColumnsShowFocus(true);
  for (int show = 0; show <= static_cast<int>(LibraryShow::Missed); ++show)
    shown_->addItem(displayName(static_cast<LibraryShow>(show)));
  for (int grouping = 0; grouping < kGroupings; ++grouping)
    grouping_->addItem(displayName(static_cast<Grouping>(grouping)));
  shown_->setAccessibleName(tr("Clips that are shown"));
  shown_->setToolTip(tr("Filter of shown clips"));
  grouping_->setAccessibleName(tr("Groups of the clips"));
  grouping_->setToolTip(tr("Grouping of clips"));
  for (QComboBox* box : {shown_, grouping_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(6);
  }
  makeHead();
  view_->setIndentation(14);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  view_->setAccessibleName(tr("Clips of the project"));
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(view_, &QWidget::customContextMenuRequested, this, &LibraryPanel::showMenu);
  add_->setToolTip(tr("Add motion files to the project. Each keeps its own settings."));
  auto* ways = new QMenu(add_);
  ways->addAction(tr("&Clips…"), this, &LibraryPanel::addRequested);
  ways->addAction(tr("&Folder…"), this, &LibraryPanel::addFolderRequested);
  add_->setMenu(ways);
  remove_->setToolTip(tr("Remove the selected clips from the project; their files stay."));
  verdict_->setAccessibleName(tr("Verdict"));
  verdict_->setToolTip(tr("Verdict on the selected clips, with their present files and settings."));
  verdict_->addItem(tr("Not reviewed"), static_cast<int>(Verdict::None));
  verdict_->addItem(tr("Approved"), static_cast<int>(Verdict::Approved));
  verdict_->addItem(tr("Rejected"), static_cast<int>(Verdict::Rejected));
  note_->setAccessibleName(tr("Note"));
  note_->setPlaceholderText(tr("Note about this clip"));
  note_->setToolTip(tr("The project keeps this note with the verdict."));
  note_->setClearButtonEnabled(true);

  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_, 1);
  buttons->addWidget(remove_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 8);
  column->setSpacing(6);
  auto* order = new QToolButton(this);
  order->setText(QStringLiteral("⋯"));
  order->setAccessibleName(tr("Order and columns"));
  order->setToolTip(tr("What clips are sorted by, and the columns beside them"));
  connect(order, &QToolButton::clicked, this, [this, order] {
    makeColumnMenu()->popup(order->mapToGlobal(QPoint(0, order->height())));
  });
  auto* above = new QVBoxLayout;
  above->setContentsMargins(8, 0, 8, 0);
  auto* first = new QHBoxLayout;
  first->addWidget(filter_, 1);
  first->addWidget(order);
  above->addLayout(first);
  auto* choices = new QHBoxLayout;
  choices->addWidget(shown_, 1);
  choices->addWidget(grouping_, 1);
  above->addLayout(choices);
  column->addLayout(above);
  column->addWidget(view_, 1);
  auto* below = new QVBoxLayout;
  below->setContentsMargins(8, 0, 8, 0);
  below->addWidget(sum_);
  below->addWidget(encoding_);
  below->addWidget(reviewed_);
  below->addWidget(verdict_);
  below->addWidget(note_);
  below->addLayout(buttons);
  column->addLayout(below);

  connect(filter_, &QLineEdit::textChanged, tree_, &LibraryTree::setFilter);
  connect(shown_, &QComboBox::currentIndexChanged, tree_,
          [this](int show) { tree_->setShow(static_cast<LibraryShow>(show)); });
  connect(grouping_, &QComboBox::currentIndexChanged, tree_, [this](int grouping) {
    tree_->setGrouping(static_cast<Grouping>(grouping));
    emit arrangementChanged();
  });
  connect(remove_, &QPushButton::clicked, this, &LibraryPanel::removeChosen);
  connect(view_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    const int row = current();
    if (row >= 0) chosen_ = model_->entry(row).key();
    showReview();
    if (row >= 0) emit openRequested(row);
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &LibraryPanel::noteSelection);
  connect(view_, &QTreeView::collapsed, this,
          [this](const QModelIndex& folder) { collapsed_.insert(tree_->folderPath(folder)); });
  connect(view_, &QTreeView::expanded, this,
          [this](const QModelIndex& folder) { collapsed_.remove(tree_->folderPath(folder)); });
  connect(model, &LibraryModel::dataChanged, this, &LibraryPanel::showSum);
  connect(tree_, &LibraryTree::modelAboutToBeReset, this,
          [this] { scrolled_ = view_->verticalScrollBar()->value(); });
  connect(tree_, &LibraryTree::modelReset, this, &LibraryPanel::showTree);
  connect(verdict_, &QComboBox::activated, this, [this] {
    emit verdictChosen(reviewedRows(), static_cast<Verdict>(verdict_->currentData().toInt()));
  });
  connect(note_, &QLineEdit::textEdited, this,
          [this](const QString& note) { emit noteEdited(current(), note); });
  showTree();
}

/// Sets up the header. A third click on a title restores the library's order.
void LibraryPanel::makeHead() {
  QHeaderView* head = view_->header();
  head->setSortIndicator(-1, Qt::AscendingOrder);
  head->setSortIndicatorClearable(true);
  head->setStretchLastSection(false);
  head->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setSortingEnabled(true);
  for (int column = 1; column < kLibraryColumns; ++column) {
    head->hideSection(column);
    head->resizeSection(column, head->fontMetrics().averageCharWidth() * kColumnWidth);
  }
  view_->viewport()->installEventFilter(this);
  connect(head, &QWidget::customContextMenuRequested, this,
          [this, head](const QPoint& place) { makeColumnMenu()->popup(head->mapToGlobal(place)); });
  connect(head, &QHeaderView::sectionResized, this, [this](int column) {
    fitColumns();
    if (column > 0) noteArrangement();
  });
  connect(head, &QHeaderView::sectionMoved, this, &LibraryPanel::noteArrangement);
  connect(head, &QHeaderView::sortIndicatorChanged, this, &LibraryPanel::noteArrangement);
}

bool LibraryPanel::isSortedByComparison() const {
  return isOfComparison(static_cast<LibraryColumn>(view_->header()->sortIndicatorSection()));
}

/// Remembers the user's own sort order. Sorting by a comparison does not replace it.
void LibraryPanel::noteArrangement() {
  const QHeaderView* head = view_->header();
  if (!isSortedByComparison())
    own_sort_ = {head->sortIndicatorSection(), head->sortIndicatorOrder()};
  emit arrangementChanged();
}

bool LibraryPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_->viewport() && event->type() == QEvent::Resize) fitColumns();
  return QWidget::eventFilter(watched, event);
}

int LibraryPanel::columnsWidth() const {
  const QHeaderView* head = view_->header();
  int width = 0;
  for (int column = 1; column < kLibraryColumns; ++column)
    if (!head->isSectionHidden(column)) width += head->sectionSize(column);
  return width;
}

QSize LibraryPanel::minimumSizeHint() const {
  const int column = view_->header()->fontMetrics().averageCharWidth() * kColumnWidth;
  return {210 + std::min(columnsWidth(), kRoomyColumns * column), 200};
}

/// Gives the clips' column the width that the others leave, but at least a readable one.
void LibraryPanel::fitColumns() {
  QHeaderView* head = view_->header();
  const int others = columnsWidth();
  const int width = std::max(view_->viewport()->width() - others, others > 0 ? kClipWidth : 0);
  if (head->sectionSize(0) != width) head->resizeSection(0, width);
}

QMenu* LibraryPanel::makeColumnMenu() {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (int column = 1; column < kLibraryColumns; ++column) {
    QAction* action = menu->addAction(titleOf(static_cast<LibraryColumn>(column)));
    action->setCheckable(true);
    action->setChecked(!view_->isColumnHidden(column));
    connect(action, &QAction::toggled, this, [this, column](bool shown) {
      view_->setColumnHidden(column, !shown);
      updateGeometry();
      fitColumns();
      emit arrangementChanged();
    });
  }
  menu->addSeparator();
  addOrders(menu->addMenu(tr("Sort By")));
  return menu;
}

/// Adds the sort orders: names ascending, all else with the largest first. Choosing the current
/// order again reverses it.
void LibraryPanel::addOrders(QMenu* menu) {
  const QHeaderView* head = view_->header();
  const int sorted = head->sortIndicatorSection();
  const auto add = [&](const QString& title, int column) {
    QAction* action = menu->addAction(title);
    action->setCheckable(true);
    action->setChecked(sorted == column);
    const auto kind = static_cast<LibraryColumn>(column);
    const bool falls = column == sorted
                           ? head->sortIndicatorOrder() == Qt::AscendingOrder
                           : kind != LibraryColumn::Clip && kind != LibraryColumn::FromPreset;
    connect(action, &QAction::triggered, this, [this, column, falls] {
      view_->sortByColumn(column, falls ? Qt::DescendingOrder : Qt::AscendingOrder);
    });
  };
  add(tr("Order of the Library"), -1);
  for (int column = 0; column < kLibraryColumns; ++column)
    add(titleOf(static_cast<LibraryColumn>(column)), column);
}

void LibraryPanel::showComparison(bool shown) {
  for (int column = 1; column < kLibraryColumns; ++column)
    if (isOfComparison(static_cast<LibraryColumn>(column))) {
      view_->setColumnHidden(column, !shown);
      if (shown) view_->resizeColumnToContents(column);
    }
  if (shown)
    view_->sortByColumn(static_cast<int>(LibraryColumn::Since), Qt::DescendingOrder);
  else if (isSortedByComparison())
    view_->sortByColumn(own_sort_.first, own_sort_.second);
  updateGeometry();
  fitColumns();
}

QByteArray LibraryPanel::arrangement() const {
  QHeaderView* head = view_->header();
  const int section = head->sortIndicatorSection();
  const Qt::SortOrder order = head->sortIndicatorOrder();
  const QSignalBlocker blocker(head);
  if (isSortedByComparison()) head->setSortIndicator(own_sort_.first, own_sort_.second);
  const QByteArray state = head->saveState();
  head->setSortIndicator(section, order);
  return QByteArray::number(grouping_->currentIndex()) + ' ' + state;
}

void LibraryPanel::arrange(const QByteArray& arrangement) {
  const auto space = arrangement.indexOf(' ');
  QHeaderView* head = view_->header();
  if (space < 0 || !head->restoreState(arrangement.mid(space + 1))) return;
  head->setSortIndicatorClearable(true);
  view_->sortByColumn(head->sortIndicatorSection(), head->sortIndicatorOrder());
  grouping_->setCurrentIndex(arrangement.left(space).toInt());
  showComparison(false);  // a comparison belongs to a project; old arrangements lack its columns
}

void LibraryPanel::showMenu(const QPoint& place) {
  makeMenu()->popup(view_->viewport()->mapToGlobal(place));
}

void LibraryPanel::addVerdicts(QMenu* menu, const std::vector<int>& rows) {
  QMenu* verdicts = menu->addMenu(tr("Verdict"));
  verdicts->setEnabled(!rows.empty());
  for (int item = 0; item < verdict_->count(); ++item) {
    const auto verdict = static_cast<Verdict>(verdict_->itemData(item).toInt());
    connect(verdicts->addAction(verdict_->itemText(item)), &QAction::triggered, this,
            [this, rows, verdict] { emit verdictChosen(rows, verdict); });
  }
}

void LibraryPanel::addSettings(QMenu* menu, const std::vector<int>& rows) {
  const auto add = [&](const QString& text, bool enabled, const auto& act) {
    QAction* action = menu->addAction(text);
    action->setEnabled(enabled && !rows.empty());
    connect(action, &QAction::triggered, this, act);
  };
  const int row = current();
  add(tr("Copy Settings"), row >= 0, [this, row] { emit copySettingsRequested(row); });
  add(tr("Paste Settings"), can_paste_, [this, rows] { emit pasteSettingsRequested(rows); });
  add(tr("Paste Importance Only"), can_paste_,
      [this, rows] { emit pasteImportanceRequested(rows); });
  menu->addSeparator();
  add(tr("Put a Character On…"), true, [this, rows] { emit putCharacterRequested(rows); });
  add(tr("Take the Character Off"), true, [this, rows] { emit takeCharacterOffRequested(rows); });
}

QMenu* LibraryPanel::makeMenu() {
  const std::vector<int> rows = chosenRows();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addVerdicts(menu, rows);
  const LibraryEntry shown = current() >= 0 ? model_->entry(current()) : LibraryEntry();
  QAction* notes = menu->addAction(tr("Notes on Reading"));
  notes->setEnabled(!notesOf(shown).isEmpty());
  connect(notes, &QAction::triggered, this, [this, shown] {
    const QRect row = view_->visualRect(view_->currentIndex());
    showNotes(shown, view_->viewport()->mapToGlobal(row.bottomLeft()));
  });
  QMenu* presets = menu->addMenu(tr("Preset"));
  presets->setEnabled(!rows.empty() && !presets_.empty());
  for (const Settings& preset : presets_)
    connect(presets->addAction(displayName(preset)), &QAction::triggered, this,
            [this, rows, preset] { emit presetChosen(rows, preset); });
  addSettings(menu, rows);
  menu->addSeparator();
  QAction* selected = menu->addAction(tr("Export Selected, Each with Its Own Settings…"));
  selected->setEnabled(!rows.empty());
  connect(selected, &QAction::triggered, this, [this, rows] { emit exportRequested(rows); });
  QAction* all = menu->addAction(tr("Export All, Each with Its Own Settings…"));
  all->setEnabled(model_->rowCount() > 0);
  connect(all, &QAction::triggered, this, [this] { emit exportRequested({}); });
  menu->addSeparator();
  QAction* find = menu->addAction(tr("Find Missing Clips in a Folder…"));
  bool any_missing = false;
  for (int row = 0; row < model_->rowCount(); ++row)
    any_missing = any_missing || model_->entry(row).missing;
  find->setEnabled(any_missing);
  connect(find, &QAction::triggered, this, &LibraryPanel::findMissingRequested);
  return menu;
}

/// Returns the selection if it includes the clip that is shown, else that clip alone.
std::vector<int> LibraryPanel::reviewedRows() const {
  std::vector<int> rows = chosenRows();
  const int row = current();
  if (row >= 0 && std::find(rows.begin(), rows.end(), row) == rows.end()) rows = {row};
  return rows;
}

int LibraryPanel::nextToReview() const {
  const std::vector<int> clips = tree_->clipsBelow({});
  const auto here = std::find(clips.begin(), clips.end(), current());
  const auto waits = [this](int clip) { return wantsReview(model_->entry(clip)); };
  const auto after = here == clips.end() ? clips.begin() : here + 1;
  auto found = std::find_if(after, clips.end(), waits);
  if (found == clips.end()) {
    found = std::find_if(clips.begin(), after, waits);
    if (found == after) return -1;
  }
  return *found == current() ? -1 : *found;
}

int LibraryPanel::current() const {
  return tree_->clipOf(view_->currentIndex());
}

void LibraryPanel::setCurrent(int row) {
  chosen_ = row >= 0 ? model_->entry(row).key() : QString();
  if (const QModelIndex index = tree_->indexOf(row); index != view_->currentIndex()) {
    using Selection = QItemSelectionModel;
    Selection* selection = view_->selectionModel();
    const QSignalBlocker blocker(selection);
    // A clip that is already selected becomes current without changing the selection.
    selection->setCurrentIndex(index, selection->isSelected(index)
                                          ? Selection::SelectionFlags(Selection::NoUpdate)
                                          : Selection::ClearAndSelect | Selection::Rows);
    selected_ = keysOf(chosenRows());
    if (index.isValid()) view_->scrollTo(index);
  }
  view_->viewport()->update();
  showReview();
}

/// Shows the rebuilt tree with the same folders collapsed and the same clips selected.
void LibraryPanel::showTree() {
  {
    const QSignalBlocker blocker(view_);
    const bool has_folders = tree_->rowCount() > 0 && tree_->clipOf(tree_->index(0, 0)) < 0;
    view_->setRootIsDecorated(has_folders);
    view_->setUniformRowHeights(!has_folders);  // else each change adds up the heights of all rows
    view_->expandAll();
    const auto show_folders = [this](auto&& self, const QModelIndex& above) -> void {
      for (int row = 0; row < tree_->rowCount(above); ++row) {
        const QModelIndex index = tree_->index(row, 0, above);
        if (tree_->clipOf(index) >= 0) break;  // folders come first
        view_->setFirstColumnSpanned(row, above, true);
        self(self, index);
        if (collapsed_.contains(tree_->folderPath(index))) view_->collapse(index);
      }
    };
    show_folders(show_folders, {});
  }
  using Selection = QItemSelectionModel;
  const QSignalBlocker blocker(view_->selectionModel());
  view_->setCurrentIndex(tree_->indexOf(model_->rowOf(chosen_)));
  QItemSelection selection;
  for (int row = 0; row < model_->rowCount() && !selected_.isEmpty(); ++row)
    if (selected_.contains(model_->entry(row).key()))
      if (const QModelIndex index = tree_->indexOf(row); index.isValid())
        selection.append(QItemSelectionRange(index));
  view_->selectionModel()->select(selection, Selection::Select | Selection::Rows);
  view_->verticalScrollBar()->setValue(scrolled_);
  showReview();
}

void LibraryPanel::noteSelection() {
  selected_ = keysOf(chosenRows());
  showReview();
}

QSet<QString> LibraryPanel::keysOf(const std::vector<int>& rows) const {
  QSet<QString> keys;
  for (const int row : rows) keys.insert(model_->entry(row).key());
  return keys;
}

std::vector<int> LibraryPanel::chosenRows() const {
  std::vector<int> rows;
  QSet<int> known;
  for (const QItemSelectionRange& range : view_->selectionModel()->selection())
    for (int at = range.top(); range.left() == 0 && at <= range.bottom(); ++at)
      for (const int row : tree_->clipsBelow(tree_->index(at, 0, range.parent()))) {
        if (known.contains(row)) continue;
        known.insert(row);
        rows.push_back(row);
      }
  return rows;
}

std::vector<int> LibraryPanel::rowsInSight() const {
  std::vector<int> rows;
  const int bottom = view_->viewport()->height();
  for (QModelIndex index = view_->indexAt({0, 0});
       index.isValid() && view_->visualRect(index).top() < bottom; index = view_->indexBelow(index))
    if (const int row = tree_->clipOf(index); row >= 0) rows.push_back(row);
  return rows;
}

void LibraryPanel::showSum() {
  sum_->setVisible(selected_.size() > 1);
  if (selected_.size() > 1) sum_->setText(sumText(*model_, chosenRows()));
}

void LibraryPanel::removeChosen() {
  const std::vector<int> rows = chosenRows();
  if (rows.empty()) return;
  emit removeRequested(QList<int>(rows.begin(), rows.end()));
}

void LibraryPanel::showReview() {
  showSum();
  const int row = current();
  verdict_->setEnabled(!reviewedRows().empty());
  note_->setEnabled(row >= 0);
  remove_->setEnabled(view_->selectionModel()->hasSelection());
  const LibraryEntry shown = row >= 0 ? model_->entry(row) : LibraryEntry();
  verdict_->setCurrentIndex(verdict_->findData(static_cast<int>(shown.review.verdict)));
  const QString note = QString::fromStdString(shown.review.note);
  if (note_->text() != note) note_->setText(note);
}

}  // namespace mocapress
