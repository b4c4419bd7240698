// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/foreign_lock.h"

#include <QFileInfo>
#include <QLockFile>
#include <QSysInfo>

#include "app/studio/library/kept_project.h"

namespace mocapress {

std::optional<ForeignLock> foreignLock(const QString& project) {
  const QString file = ProjectLock::fileOf(project);
  qint64 process = 0;
  QString host, program;
  if (!QLockFile(file).getLockInfo(&process, &host, &program)) return std::nullopt;
  if (host.isEmpty() || host == QSysInfo::machineHostName()) return std::nullopt;
  const QFileInfo status(file);
  return ForeignLock{host, status.owner(), status.lastModified()};
}

bool removeForeignLock(const QString& project) {
  return foreignLock(project) && QLockFile(ProjectLock::fileOf(project)).removeStaleLockFile();
}

}  // namespace mocapress
