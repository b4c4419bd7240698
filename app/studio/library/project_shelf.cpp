// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project_shelf.h"

#include <QDateTime>
#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QRandomGenerator>
#include <QThread>
#include <chrono>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/path_kind.h"

namespace mocapress {
namespace {

constexpr qsizetype kMostListed = 100;
constexpr std::chrono::seconds kPatience{10};  // longest wait for another studio's lock
constexpr unsigned long kPause = 10;           // ms between two attempts to get the lock
const QString kProjects = QStringLiteral("projects");

/// Throws InputError if the list exists but cannot be read.
QStringList readList(const QString& file) {
  const std::filesystem::path path = file.toStdU16String();
  QStringList paths;
  if (!is_there(path)) return paths;
  const QByteArray text = QByteArray::fromStdString(read_text(path));
  const QJsonObject json = QJsonDocument::fromJson(text).object();
  for (const auto& one : json.value(kProjects).toArray()) paths << one.toString();
  paths.removeAll(QString());
  return paths;
}

}  // namespace

ProjectShelf::ProjectShelf(const QString& folder) {
  QDir().mkpath(folder);
  // Canonical, to be equal to the paths of opened files.
  const QString canonical = QDir(folder).canonicalPath();
  folder_ = canonical.isEmpty() ? QDir(folder).absolutePath() : canonical;
}

QStringList ProjectShelf::listed() const {
  try {
    return readList(list());
  } catch (const Error&) {
    return {};  // use() reports the error before it writes the list
  }
}

QString ProjectShelf::inUse() const {
  const QStringList paths = listed();
  return paths.isEmpty() ? projects().value(0) : paths.front();
}

void ProjectShelf::use(const QString& path) const {
  if (listed().value(0) == path) return;
  // Locks the list, so that two studios keep each other's entries.
  QLockFile lock(list() + QStringLiteral(".lock"));
  const QDeadlineTimer deadline(kPatience);
  while (!lock.tryLock(0)) {
    if (lock.error() != QLockFile::LockFailedError || deadline.hasExpired())
      throw WriteError(list().toStdString() + ": cannot be locked");
    QThread::msleep(kPause);
  }
  QStringList paths = readList(list());
  paths.removeAll(path);
  paths.removeIf([this](const QString& one) { return isUnnamed(one) && !QFile::exists(one); });
  paths.prepend(path);
  paths.resize(std::min(paths.size(), kMostListed));
  const QByteArray text =
      QJsonDocument(QJsonObject{{kProjects, QJsonArray::fromStringList(paths)}}).toJson();
  write_text(list().toStdU16String(), {text.constData(), static_cast<std::size_t>(text.size())});
}

QStringList ProjectShelf::projects() const {
  QStringList paths = listed();
  paths.removeIf([](const QString& path) { return !QFile::exists(path); });
  // Includes unnamed projects that are on no list, for example after the list was lost.
  const QDir own(unnamedFolder());
  for (const QFileInfo& file :
       own.entryInfoList({QStringLiteral("*.mocapress")}, QDir::Files, QDir::Time))
    if (!paths.contains(file.absoluteFilePath())) paths << file.absoluteFilePath();
  return paths;
}

QString ProjectShelf::unnamedPath() const {
  QDir().mkpath(unnamedFolder());
  const QString date = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmm"));
  QString path;
  do {
    const QString random =
        QString::number(QRandomGenerator::system()->generate(), 16).rightJustified(8, u'0');
    path = QStringLiteral("%1/%2-%3.mocapress").arg(unnamedFolder(), date, random);
  } while (QFile::exists(path));
  return path;
}

bool ProjectShelf::isUnnamed(const QString& path) const {
  return QFileInfo(path).absolutePath() == unnamedFolder();
}

}  // namespace mocapress
