// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/study_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "core/codec/methods/compression_method.h"
#include "widgets/models/colours.h"
#include "widgets/models/display_names.h"
#include "widgets/panels/number_fields.h"

namespace mocapress {

namespace {

constexpr int kLeastHeight = 84;

}  // namespace

StudyClips::StudyClips(QWidget* parent)
    : QWidget(parent), list_(new QListWidget(this)), remove_(new QPushButton(tr("Remove"), this)) {
  setAcceptDrops(true);
  list_->setAccessibleName(tr("Clips of the study"));
  list_->setToolTip(tr("Drop files or folders here."));
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setUniformItemSizes(true);
  list_->setMinimumHeight(kLeastHeight);
  auto* files = new QPushButton(tr("Add Files…"), this);
  files->setToolTip(tr("Add motions"));
  auto* folder = new QPushButton(tr("Add Folder…"), this);
  folder->setToolTip(tr("Add every motion below a folder"));
  remove_->setToolTip(tr("Remove the selected clips from the list (Del)"));
  remove_->setEnabled(false);

  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  for (QPushButton* button : {files, folder, remove_}) buttons->addWidget(button);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(list_);
  column->addLayout(buttons);

  auto* remove_by_key = new QAction(this);
  remove_by_key->setShortcut(QKeySequence::Delete);
  remove_by_key->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(remove_by_key);
  connect(remove_by_key, &QAction::triggered, this, &StudyClips::removeSelected);
  connect(remove_, &QPushButton::clicked, this, &StudyClips::removeSelected);
  connect(files, &QPushButton::clicked, this, &StudyClips::addFilesRequested);
  connect(folder, &QPushButton::clicked, this, &StudyClips::addFolderRequested);
  connect(list_, &QListWidget::itemSelectionChanged, this,
          [this] { remove_->setEnabled(!list_->selectedItems().isEmpty()); });
}

void StudyClips::setClips(const QStringList& paths) {
  QStringList shown;
  for (int i = 0; i < list_->count(); ++i) shown << list_->item(i)->data(Qt::UserRole).toString();
  if (shown == paths) return;
  list_->clear();
  for (const QString& path : paths) {
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), list_);
    item->setData(Qt::UserRole, path);
    item->setToolTip(path);
  }
}

void StudyClips::removeSelected() {
  QStringList paths;
  for (const QListWidgetItem* item : list_->selectedItems())
    paths << item->data(Qt::UserRole).toString();
  if (!paths.isEmpty()) emit removeRequested(paths);
}

void StudyClips::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StudyClips::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  if (paths.isEmpty()) return;
  event->acceptProposedAction();
  emit dropped(paths);
}

namespace {

constexpr double kFirstIkRatio = 16;

QLabel* makeHeading(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  QFont font = label->font();
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  return label;
}

}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QWidget(parent),
      clips_(new StudyClips(this)),
      methods_(new QListWidget(this)),
      hold_feet_(new QCheckBox(tr("Also with feet held"), this)),
      ik_ratio_(new QDoubleSpinBox(this)),
      ratios_(new NumberListEdit(this)),
      errors_(new NumberListEdit(this)),
      weighting_(new QComboBox(this)),
      folder_(new QPushButton(this)),
      run_(new QPushButton(this)),
      progress_(new QProgressBar(this)),
      status_(new QLabel(this)) {
  fillMethods();
  progress_->setAccessibleName(tr("Progress of the study"));
  progress_->setTextVisible(false);
  progress_->setMaximumHeight(8);
  status_->setWordWrap(true);
  status_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  run_->setDefault(true);
  run_->setToolTip(tr("Measurements that are already there are kept."));

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 8, 10, 10);
  column->setSpacing(6);
  column->addWidget(makeHeading(tr("Clips"), this));
  column->addWidget(clips_, 1);
  column->addSpacing(4);
  column->addWidget(makeHeading(tr("Methods"), this));
  column->addWidget(methods_);
  column->addWidget(makeFeet());
  column->addSpacing(4);
  column->addWidget(makeHeading(tr("Targets"), this));
  column->addWidget(makeTargets());
  column->addSpacing(4);
  column->addWidget(run_);
  column->addWidget(progress_);
  column->addWidget(status_);

  connect(run_, &QPushButton::clicked, this,
          [this] { running_ ? emit cancelRequested() : emit runRequested(); });
  connect(folder_, &QPushButton::clicked, this, &StudyPanel::folderRequested);
  setFolder({});
  setRunning(false, false);
  setProgress(0, 1);
}

void StudyPanel::fillMethods() {
  methods_->setAccessibleName(tr("Methods of the study"));
  methods_->setUniformItemSizes(true);
  methods_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  for (const CompressionMethod& compression_method : compression_methods()) {
    auto* item = new QListWidgetItem(methodTitle(compression_method.name), methods_);
    item->setData(Qt::UserRole, QString::fromUtf8(compression_method.name));
    item->setToolTip(QStringLiteral("<p>%1</p>")
                         .arg(QString::fromUtf8(compression_method.note).toHtmlEscaped()));
    item->setFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setCheckState(Qt::Unchecked);
    QPixmap swatch(9, 9);
    swatch.fill(seriesStyle(compression_method.name, false).colour);
    item->setIcon(swatch);
  }
  methods_->setIconSize({9, 9});
  const int rows = methods_->sizeHintForRow(0) * methods_->count();
  methods_->setFixedHeight(rows + 2 * methods_->frameWidth());
  connect(methods_, &QListWidget::itemChanged, this, &StudyPanel::change);
}

QWidget* StudyPanel::makeFeet() {
  hold_feet_->setToolTip(
      tr("Adds a curve of annealed wavelets with feet held by inverse kinematics, at the same "
         "ratios."));
  ik_ratio_->setAccessibleName(tr("IK ratio of the study"));
  ik_ratio_->setToolTip(tr("Coefficient ratio of the IK correction (r_IK)."));
  ik_ratio_->setRange(1, 200);
  ik_ratio_->setDecimals(1);
  ik_ratio_->setSuffix(tr(":1"));
  ik_ratio_->setValue(kFirstIkRatio);
  ik_ratio_->setEnabled(false);
  auto* feet = new QWidget(this);
  auto* row = new QHBoxLayout(feet);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(hold_feet_, 1);
  row->addWidget(ik_ratio_);
  connect(hold_feet_, &QCheckBox::toggled, this, &StudyPanel::change);
  connect(ik_ratio_, &QDoubleSpinBox::valueChanged, this, &StudyPanel::change);
  return feet;
}

QWidget* StudyPanel::makeTargets() {
  ratios_->setAccessibleName(tr("Ratios to reach"));
  ratios_->setToolTip(tr("Compression ratios, separated by spaces."));
  errors_->setAccessibleName(tr("Errors to keep, in cm"));
  errors_->setToolTip(tr("Errors eps_x to compress to, in centimetres, separated by spaces."));
  weighting_->setAccessibleName(tr("Weighting of the study"));
  weighting_->setToolTip(tr(
      "Points on which the error eps_x is measured. Surface: a body modelled around the bones, so "
      "that turned heads and hands count. Shell: three points 3 cm from every joint, as in ACL. "
      "Bone ends and joint "
      "origins: points on the bones, weighted by bone length; joint origins are the paper's."));
  for (const Weighting weighting : kWeightings)
    weighting_->addItem(displayName(weighting), static_cast<int>(weighting));
  auto* targets = new QWidget(this);
  auto* form = new QFormLayout(targets);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(10);
  form->setVerticalSpacing(5);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("Ratios"), ratios_);
  form->addRow(tr("Errors (cm)"), errors_);
  form->addRow(tr("Weighting"), weighting_);
  form->addRow(tr("Kept in"), folder_);
  connect(ratios_, &NumberListEdit::numbersChanged, this, &StudyPanel::change);
  connect(errors_, &NumberListEdit::numbersChanged, this, &StudyPanel::change);
  connect(weighting_, &QComboBox::activated, this, &StudyPanel::change);
  return targets;
}

void StudyPanel::setSettings(const StudySettings& settings) {
  const QScopedValueRollback filling(filling_, true);
  settings_ = settings;
  clips_->setClips(settings.clips);
  for (int i = 0; i < methods_->count(); ++i) {
    QListWidgetItem* item = methods_->item(i);
    const bool chosen = settings.methods.contains(item->data(Qt::UserRole).toString());
    item->setCheckState(chosen ? Qt::Checked : Qt::Unchecked);
  }
  hold_feet_->setChecked(settings.ik_ratio.has_value());
  ik_ratio_->setEnabled(settings.ik_ratio.has_value());
  if (settings.ik_ratio) ik_ratio_->setValue(*settings.ik_ratio);
  ratios_->setNumbers(settings.ratios);
  errors_->setNumbers(settings.errors);
  weighting_->setCurrentIndex(weighting_->findData(static_cast<int>(settings.weighting)));
}

void StudyPanel::change() {
  if (filling_) return;
  settings_.methods.clear();
  for (int i = 0; i < methods_->count(); ++i)
    if (methods_->item(i)->checkState() == Qt::Checked)
      settings_.methods << methods_->item(i)->data(Qt::UserRole).toString();
  ik_ratio_->setEnabled(hold_feet_->isChecked());
  settings_.ik_ratio.reset();
  if (hold_feet_->isChecked()) settings_.ik_ratio = ik_ratio_->value();
  settings_.ratios = ratios_->numbers();
  settings_.errors = errors_->numbers();
  settings_.weighting = static_cast<Weighting>(weighting_->currentData().toInt());
  emit settingsChanged(settings_);
}

void StudyPanel::setFolder(const QString& folder) {
  folder_->setText(folder.isEmpty() ? tr("This computer's cache") : QDir(folder).dirName());
  folder_->setAccessibleName(tr("Folder of the study: %1").arg(folder_->text()));
  folder_->setToolTip(tr("Folder for measurements, from which a stopped study continues. Click to "
                         "choose a folder; if it holds a study, that study is shown.\n%1")
                          .arg(QDir::toNativeSeparators(folder)));
}

void StudyPanel::setRunning(bool running, bool canRun) {
  running_ = running;
  run_->setText(running ? tr("Cancel") : tr("Run Study"));
  run_->setEnabled(running || canRun);
  folder_->setEnabled(!running);
}

void StudyPanel::setProgress(int done, int jobs) {
  progress_->setRange(0, jobs);
  progress_->setValue(done);
}

void StudyPanel::setStatus(const QString& status) {
  status_->setText(status);
}

}  // namespace mocapress
