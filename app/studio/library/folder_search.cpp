// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/folder_search.h"

#include "core/batch/batch.h"

namespace mocapress {

void FolderSearch::search(const QString& folder) {
  folders_ << folder;
  searchNext();
}

void FolderSearch::abandon() {
  folders_.clear();
  finding_.abandon();
}

void FolderSearch::searchNext() {
  if (finding_.busy() || folders_.isEmpty()) return;
  const QString folder = folders_.takeFirst();
  // The runner is still busy inside its delivery.
  const auto go_to_next = [this] {
    QMetaObject::invokeMethod(this, &FolderSearch::searchNext, Qt::QueuedConnection);
  };
  finding_.start(
      [folder](const Job&) {
        QStringList clips;
        for (const SourceClip& clip : find_sources({folder.toStdString()}))
          if (clip.problem.empty()) clips << QString::fromStdString(clip.path);
        return clips;
      },
      [this, folder, go_to_next](const QStringList& clips) {
        if (clips.isEmpty()) emit failed(tr("There are no clips in %1.").arg(folder));
        emit found(clips);
        go_to_next();
      },
      [this, go_to_next](const QString& message) {
        emit failed(message);
        go_to_next();
      });
}

}  // namespace mocapress
