// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/window/incoming_files.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>
#include <QWidget>
#include <utility>

#include "app/studio/document/clip_files.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"
#include "app/studio/library/project_files.h"
#include "app/studio/window/notices.h"
#include "core/formats/clip_files.h"

namespace mocapress {

IncomingFiles::IncomingFiles(Session* session, Library* library, ClipFiles* files,
                             ProjectFiles* projects, Notices* notices, QWidget* window)
    : QObject(window),
      session_(session),
      library_(library),
      files_(files),
      projects_(projects),
      notices_(notices) {
  window->setAcceptDrops(true);
  window->installEventFilter(this);
  connect(library, &Library::added, this, [this](int row) {
    if (std::exchange(opens_added_, false)) library_->openClip(row);
  });
}

bool IncomingFiles::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::DragEnter) {
    auto& drag = static_cast<QDragEnterEvent&>(*event);
    const QList<QUrl> urls = drag.mimeData()->urls();
    if (!urls.isEmpty() && urls.front().isLocalFile()) drag.acceptProposedAction();
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto& drop = static_cast<QDropEvent&>(*event);
    drop.acceptProposedAction();
    QStringList paths;
    for (const QUrl& url : drop.mimeData()->urls())
      if (url.isLocalFile()) paths << url.toLocalFile();
    open(paths);
    return true;
  }
  return QObject::eventFilter(watched, event);
}

void IncomingFiles::open(const QStringList& paths, const QString& skeleton) {
  QStringList projects, clips;
  for (const QString& path : paths) (isProjectFile(path) ? projects : clips) << path;
  if (projects.isEmpty()) return openClips(clips, skeleton, !session_->document().skeleton());
  const QString project = projects.takeFirst();
  projects_->open(project, [=, this] {
    if (!clips.isEmpty()) openClips(clips, skeleton, library_->currentRow() < 0);
    if (projects.isEmpty()) return;
    QStringList names;
    for (const QString& path : projects) names << QFileInfo(path).fileName();
    notices_->keep(tr("Left out; only one project is open at a time: %1")
                       .arg(names.join(QStringLiteral(", "))));
  });
}

void IncomingFiles::openClips(const QStringList& paths, const QString& skeleton, bool opens_first) {
  if (paths.size() == 1 && !QFileInfo(paths[0]).isDir()) return files_->open(paths[0], skeleton);
  QStringList clips, skeletons, folders, others;
  for (const QString& path : paths) {
    const QString kind = QFileInfo(path).suffix().toLower();
    if (QFileInfo(path).isDir())
      folders << path;
    else if (is_clip(path.toStdString()))
      clips << path;
    else if (kind == QLatin1String("asf"))
      skeletons << path;
    else
      others << QFileInfo(path).fileName();
  }
  if (!others.isEmpty())
    notices_->say(
        tr("Left out; the library takes only motions: %1").arg(others.join(QStringLiteral(", "))));
  if (clips.size() == 1 && folders.isEmpty())  // a single clip may come with a skeleton
    return files_->open(clips[0], skeletons.size() == 1 && clips[0].endsWith(QLatin1String(".amc"),
                                                                             Qt::CaseInsensitive)
                                      ? skeletons[0]
                                      : skeleton);
  opens_added_ = opens_added_ || opens_first;
  for (const QString& folder : folders) library_->addFolder(folder);
  library_->add(clips);
}

}  // namespace mocapress
