// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/foreign_lock.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocale>
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

QString whereOpen(const QString& project, const QString& name) {
  const QString file = name.isEmpty() ? QDir::toNativeSeparators(project) : name;
  const auto words = [](const char* text) {
    return QCoreApplication::translate("mocapress::ForeignLock", text);
  };
  const std::optional<ForeignLock> lock = foreignLock(project);
  if (!lock)
    return words(QT_TRANSLATE_NOOP("mocapress::ForeignLock",
                                   "%1 is open in another window of Mocapress"))
        .arg(file);
  const QString since = QLocale().toString(lock->since, QLocale::ShortFormat);
  if (lock->user.isEmpty())
    return words(QT_TRANSLATE_NOOP("mocapress::ForeignLock",
                                   "%1 is open on the computer %2, since %3"))
        .arg(file, lock->host, since);
  return words(QT_TRANSLATE_NOOP("mocapress::ForeignLock",
                                 "%1 is open on the computer %2, by %3, since %4"))
      .arg(file, lock->host, lock->user, since);
}

QString removeForeignLock(const QString& project, const ForeignLock& lock) {
  const QString file = ProjectLock::fileOf(project);
  if (!QFileInfo::exists(file)) return {};
  if (foreignLock(project) != lock)
    return QCoreApplication::translate(
               "mocapress::ForeignLock",
               "%1 was opened by another Mocapress meanwhile, so it was not taken over.")
        .arg(QDir::toNativeSeparators(project));
  // QLockFile finds out whether a lock is in use by writing it. The lock of another user can often
  // not be written, but anyone who may write in its folder can remove it.
  const bool removed =
      QFileInfo(file).isWritable() ? QLockFile(file).removeStaleLockFile() : QFile::remove(file);
  if (removed) return {};
  return QCoreApplication::translate(
             "mocapress::ForeignLock",
             "The project cannot be taken over: its lock %1 is still held, or you may not change "
             "it.")
      .arg(QDir::toNativeSeparators(file));
}

}  // namespace mocapress
