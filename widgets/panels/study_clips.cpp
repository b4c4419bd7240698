// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/panels/study_clips.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QVBoxLayout>

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
  remove_->setToolTip(tr("Take the selected clips off the list (Del)"));
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

}  // namespace mocapress
