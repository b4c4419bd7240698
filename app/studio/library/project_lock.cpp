// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project_lock.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace mocapress {
namespace {

constexpr int kHalfMade = 1000;  // ms after which a lock that names nobody was left behind

}  // namespace

ProjectLock::ProjectLock(const QString& project)
    : existed_(QFile::exists(fileOf(project))), lock_(fileOf(project)) {
  // However old: only a process that is gone has left it behind.
  lock_.setStaleLockTime(0);
  if (lock_.tryLock(0) || !inUse()) return;
  qint64 process = 0;
  QString host, program;
  if (lock_.getLockInfo(&process, &host, &program)) return;
  lock_.setStaleLockTime(kHalfMade);
  lock_.tryLock(2 * kHalfMade);
}

QString ProjectLock::fileOf(const QString& project) {
  const QFileInfo file(project);
  return file.dir().filePath(QStringLiteral(".%1.lock").arg(file.fileName()));
}

}  // namespace mocapress
