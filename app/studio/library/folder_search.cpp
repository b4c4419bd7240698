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
  finding_.start(
      [folder](const Job&) {
        QStringList clips;
        for (const SourceClip& clip : find_sources({folder.toStdString()}))
          if (clip.problem.empty()) clips << QString::fromStdString(clip.path);
        return clips;
      },
      [this, folder](const QStringList& clips) {
        if (clips.isEmpty()) emit failed(tr("There are no clips in %1.").arg(folder));
        emit found(clips);
        searchNext();
      },
      [this](const QString& message) {
        emit failed(message);
        searchNext();
      });
}

}  // namespace mocapress
