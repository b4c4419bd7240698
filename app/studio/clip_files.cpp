// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/clip_files.h"

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <utility>

#include "app/studio/recent_files.h"
#include "app/studio/sample_clip.h"
#include "app/studio/session.h"
#include "core/compare/comparison_method.h"

namespace mocapress {
namespace {

QString fileName(const QString& path) {
  return QFileInfo(path).fileName();
}

}  // namespace

ClipFiles::ClipFiles(Session* session, QWidget* window)
    : QObject(window), session_(session), window_(window) {
  connect(session, &Session::opened, this, [](const OpenRequest& request) {
    rememberRecentFile({request.path, request.skeleton});
  });
  connect(session, &Session::openFailed, this,
          [this](const OpenRequest& request, const QString& message) {
            unread_ = request;
            emit openFailed(message,
                            request.path.endsWith(QLatin1String(".amc"), Qt::CaseInsensitive));
          });
  connect(session, &Session::saved, this, &ClipFiles::noteSaved);
  connect(session, &Session::saveFailed, this, [this] { after_saving_ = nullptr; });
}

void ClipFiles::openFirst() {
  const QList<RecentFile> recent = recentFiles();
  const RecentFile first = recent.isEmpty() ? RecentFile{sampleClip(), {}} : recent.front();
  if (!first.path.isEmpty()) session_->open(first.path, first.skeleton);
}

void ClipFiles::open(const QString& path, const QString& skeleton) {
  leave([=, this] { session_->open(path, skeleton); });
}

void ClipFiles::openRow(const StudyRow& row) {
  const QString path = QString::fromStdString(row.clip);
  // Other settings for the clip that is open are no more than a slider does.
  if (session_->isOpen(path) && !find_comparison_method(row.method)) return session_->openRow(row);
  leave([=, this] { session_->openRow(row, rememberedSkeleton(path)); });
}

void ClipFiles::chooseClip() {
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Open"), directory(),
      tr("Motion and compressed clips (*.bvh *.amc *.mcpr);;All files (*)"));
  if (!path.isEmpty()) open(path);
}

void ClipFiles::chooseSkeleton() {
  const QString skeleton =
      QFileDialog::getOpenFileName(window_, tr("Skeleton of %1").arg(fileName(unread_.path)),
                                   QFileInfo(unread_.path).path(), tr("Skeletons (*.asf)"));
  if (skeleton.isEmpty()) return;
  if (unread_.compare)
    session_->compareWith(unread_.path, skeleton);
  else
    session_->open(unread_.path, skeleton);
}

void ClipFiles::chooseOriginal() {
  const QString path = QFileDialog::getOpenFileName(window_, tr("Compare with Original"),
                                                    directory(), tr("Motion (*.bvh *.amc)"));
  if (!path.isEmpty()) session_->compareWith(path);
}

void ClipFiles::save() {
  const QString& path = session_->document().savedPath();
  if (path.isEmpty())
    saveAs();
  else
    session_->save(path);
}

void ClipFiles::saveAs() {
  QString path = QFileDialog::getSaveFileName(window_, tr("Save Compressed Clip"), suggestedPath(),
                                              tr("Compressed clips (*.mcpr)"));
  if (path.isEmpty())
    after_saving_ = nullptr;
  else
    session_->save(path);
}

void ClipFiles::leave(std::function<void()> then) {
  const Document& document = session_->document();
  if (!document.modified()) return then();
  auto* question =
      new QMessageBox(QMessageBox::Question, tr("Unsaved Changes"),
                      tr("Save the compressed clip of %1?").arg(document.title()),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  question->setAttribute(Qt::WA_DeleteOnClose);
  connect(question, &QMessageBox::finished, this, [this, then = std::move(then)](int button) {
    if (button == QMessageBox::Discard) then();
    if (button != QMessageBox::Save) return;
    after_saving_ = then;
    save();
  });
  question->open();
}

void ClipFiles::noteSaved(const QString& path) {
  rememberRecentFile({path, {}});
  emit saved(fileName(path));
  if (after_saving_) std::exchange(after_saving_, nullptr)();
}

void ClipFiles::fillRecentMenu(QMenu* menu) {
  menu->clear();
  for (const RecentFile& file : recentFiles()) {
    QAction* action = menu->addAction(fileName(file.path));
    action->setToolTip(file.path);
    connect(action, &QAction::triggered, this, [=, this] { open(file.path, file.skeleton); });
  }
  menu->setToolTipsVisible(true);
}

QString ClipFiles::directory() const {
  const QList<RecentFile> recent = recentFiles();
  return recent.isEmpty() ? QString() : QFileInfo(recent.front().path).path();
}

QString ClipFiles::suggestedPath() const {
  const Document& document = session_->document();
  if (!document.savedPath().isEmpty()) return document.savedPath();
  const QFileInfo original(document.original()->path);
  return original.path() + QLatin1Char('/') + original.completeBaseName() + QLatin1String(".mcpr");
}

}  // namespace mocapress
