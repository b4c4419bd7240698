// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/study_results.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "core/study/results.h"
#include "widgets/models/study_rows_model.h"
#include "widgets/plots/rate_plot.h"

namespace mocapress {
namespace {

constexpr int kUpdateDelay = 120;  // ms between two updates, at least
constexpr int kRest = 4;           // an update waits this many times as long as the last one took
constexpr int kPlotHeight = 540;
constexpr int kTableHeight = 230;

}  // namespace

StudyResults::StudyResults(StudyRowsModel* model, QWidget* parent)
    : QWidget(parent),
      model_(model),
      plot_(new RatePlot(this)),
      table_(new QTreeView(this)),
      chooser_(new QComboBox(this)),
      tools_(new QWidget(this)) {
  chooser_->setAccessibleName(tr("Clips shown"));
  chooser_->setToolTip(
      tr("Show one clip, or the average: the geometric mean of all clips' ratios at equal error, "
         "with the points of all clips behind it."));
  chooser_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* label = new QLabel(tr("S&how"), this);
  label->setBuddy(chooser_);
  auto* tools = new QHBoxLayout(tools_);
  tools->setContentsMargins(8, 6, 8, 4);
  tools->addWidget(label);
  tools->addWidget(chooser_);
  tools->addStretch(1);

  makeTable();
  auto* halves = new QSplitter(Qt::Vertical, this);
  halves->addWidget(plot_);
  halves->addWidget(table_);
  halves->setStretchFactor(0, 1);
  halves->setSizes({kPlotHeight, kTableHeight});
  halves->setChildrenCollapsible(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(tools_);
  column->addWidget(halves, 1);

  plot_->setDescribe([this](int row) {
    return tr("%1\nClick to load it into the studio.").arg(model_->description(row));
  });
  update_.setSingleShot(true);
  update_.setInterval(kUpdateDelay);
  connect(&update_, &QTimer::timeout, this, &StudyResults::update);
  connect(model_, &QAbstractItemModel::rowsInserted, this, &StudyResults::updateLater);
  connect(model_, &QAbstractItemModel::modelReset, this, &StudyResults::update);
  connect(chooser_, &QComboBox::currentIndexChanged, this, &StudyResults::showClip);
  connect(plot_, &RatePlot::pointChosen, this, &StudyResults::choose);
  update();
}

void StudyResults::makeTable() {
  sorted_.setSourceModel(model_);
  sorted_.setSortRole(StudyRowsModel::SortRole);
  sorted_.setFilterRole(StudyRowsModel::ClipPathRole);
  table_->setModel(&sorted_);
  table_->setAccessibleName(tr("Rows of the study"));
  table_->setRootIsDecorated(false);
  table_->setUniformRowHeights(true);
  table_->setAlternatingRowColors(true);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setIconSize({9, 9});
  table_->setSortingEnabled(true);
  table_->sortByColumn(-1, Qt::AscendingOrder);  // starts in the order of arrival
  table_->header()->setStretchLastSection(false);
  table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->header()->setSectionResizeMode(StudyRowsModel::Method, QHeaderView::Stretch);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            plot_->setCurrentRow(index.isValid() ? sorted_.mapToSource(index).row() : -1);
          });
  connect(table_, &QTreeView::activated, this,
          [this](const QModelIndex& index) { emit rowChosen(sorted_.mapToSource(index).row()); });
}

void StudyResults::addTool(QWidget* tool) {
  tools_->layout()->addWidget(tool);
}

void StudyResults::setHint(const QString& hint) {
  plot_->setHint(hint);
}

void StudyResults::setComplete(const std::set<std::string>& complete) {
  if (complete == complete_) return;
  complete_ = complete;
  updateLater();
}

void StudyResults::setHere(const QString& path, const std::optional<CurvePoint>& here) {
  here_path_ = path;
  here_ = here;
  updateLater();
}

QString StudyResults::clip() const {
  return chooser_->currentData().toString();
}

void StudyResults::setClip(const QString& path) {
  chooser_->setCurrentIndex(std::max(0, chooser_->findData(path)));
}

void StudyResults::updateLater() {
  if (!update_.isActive()) update_.start();
}

void StudyResults::update() {
  update_.stop();
  QElapsedTimer took;
  took.start();
  fillChooser();
  showClip();
  update_.setInterval(std::max(kUpdateDelay, kRest * static_cast<int>(took.elapsed())));
}

void StudyResults::fillChooser() {
  const QSignalBlocker block(chooser_);
  const QString chosen = clip();
  const Results results(model_->rows());
  chooser_->clear();
  const auto complete = static_cast<int>(complete_.size());
  chooser_->addItem(
      complete > 0 ? tr("Average over %Ln clip(s)", nullptr, complete) : tr("All clips"),
      QString());
  for (const StudiedClip& studied : results.clips())
    chooser_->addItem(QString::fromStdString(studied.title), QString::fromStdString(studied.path));
  setClip(chosen);
  if (!model_->rows().empty()) plot_->setWeighting(results.weighting());
}

void StudyResults::showClip() {
  const QString path = clip();
  plot_->setCurves(rateCurves(model_->rows(), path.toStdString(), complete_));
  plot_->setTitle(chooser_->currentText());
  const bool here = path.isEmpty() ? chooser_->findData(here_path_) > 0 : path == here_path_;
  plot_->setHere(here ? here_ : std::nullopt);
  sorted_.setFilterRegularExpression(path.isEmpty()
                                         ? QRegularExpression()
                                         : QRegularExpression(QRegularExpression::anchoredPattern(
                                               QRegularExpression::escape(path))));
}

/// Selects the row in the table, which shows more details.
void StudyResults::choose(int row) {
  const QModelIndex index = sorted_.mapFromSource(model_->index(row, 0));
  if (index.isValid()) {
    table_->setCurrentIndex(index);
    table_->scrollTo(index);
  }
  emit rowChosen(row);
}

}  // namespace mocapress
