// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/kept_project.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSignalBlocker>
#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "app/studio/library/foreign_lock.h"
#include "core/base/error.h"
#include "core/base/path_kind.h"

namespace mocapress {

namespace {

constexpr int kHalfMade = 1000;  // ms until a lock file that names no owner counts as abandoned

/// True if the file certainly does not exist. If the system cannot tell, opening it will show.
bool isAbsent(const QString& path) {
  try {
    return !is_there(path.toStdU16String());
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

ProjectLock::ProjectLock(const QString& project)
    : file_(fileOf(project)),
      existed_(QFile::exists(file_)),
      lock_(std::make_unique<QLockFile>(file_)) {
  // Age does not matter: a lock is abandoned only when its process is gone.
  lock_->setStaleLockTime(0);
  if (!lock_->tryLock(0) && inUse()) {
    qint64 process = 0;
    QString host, program;
    if (lock_->getLockInfo(&process, &host, &program)) return;
    lock_->setStaleLockTime(kHalfMade);
    lock_->tryLock(2 * kHalfMade);
  }
  if (held()) own_ = content();
}

ProjectLock::~ProjectLock() {
  if (!held() || content() == own_) return;
  // QLockFile's destructor would remove the other studio's lock, so it must never run.
  static auto* const abandoned = new std::vector<std::unique_ptr<QLockFile>>;
  abandoned->push_back(std::move(lock_));
}

bool ProjectLock::lost() const {
  if (!held() || own_.isEmpty()) return false;
  // If the folder is absent, too, as when a network is away, the lock may still exist.
  if (isAbsent(file_)) return QFileInfo(file_).dir().exists();
  const QByteArray now = content();
  return !now.isNull() && now != own_;
}

/// The content of the lock file; null if it cannot be read.
QByteArray ProjectLock::content() const {
  QFile file(file_);
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray text = file.readAll();
  if (file.error() != QFile::NoError) return {};
  return text.isNull() ? QByteArray("") : text;
}

QString ProjectLock::fileOf(const QString& project) {
  const QFileInfo file(project);
  return file.dir().filePath(QStringLiteral(".%1.lock").arg(file.fileName()));
}

namespace {

// A change is written at once, or this long after the previous write. Including the time of the
// write itself, a crash loses less than two seconds.
constexpr std::chrono::milliseconds kWriteInterval{500};
constexpr std::chrono::milliseconds kRetryDelay{5000};  // delay after a failed write
constexpr std::size_t kMostFormer = 20;

/// The path by which a project is known and locked, however it was reached.
QString fileOf(const QString& path) {
  const QFileInfo file(path);
  return file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
}

/// The reason why a project is not written any more.
QString takenOver(const QString& project) {
  const std::optional<ForeignLock> owner = foreignLock(project);
  if (!owner)
    return KeptProject::tr(
        "its lock was replaced or removed by someone else; use Save Project As to keep the "
        "changes in another file");
  const QString computer =
      owner->user.isEmpty() ? owner->host : QStringLiteral("%1 (%2)").arg(owner->host, owner->user);
  return KeptProject::tr(
             "it was taken over on the computer %1; use Save Project As to keep the changes in "
             "another file")
      .arg(computer);
}

/// Writes the project, unless another studio has taken its lock over, and returns the error; empty:
/// none. The next start opens the project that was written last, in whichever window.
QString keep(const Project& project, const QString& path, const std::optional<ProjectShelf>& shelf,
             const ProjectLock* lock) {
  try {
    if (lock && lock->lost()) return takenOver(path);
    writeProject(path, project);
    if (shelf) shelf->use(path);
    return {};
  } catch (const std::exception& error) {
    return QString::fromStdString(error.what());
  }
}

}  // namespace

KeptProject::KeptProject(QObject* parent) : QObject(parent) {
  write_later_.setSingleShot(true);
  connect(&write_later_, &QTimer::timeout, this, &KeptProject::write);
  connect(this, &KeptProject::written, this, &KeptProject::noteWritten, Qt::QueuedConnection);
}

KeptProject::~KeptProject() {
  const QSignalBlocker nobody_left_to_tell(this);
  flush();
}

QString KeptProject::name() const {
  const bool unnamed = path_.isEmpty() || (shelf_ && shelf_->isUnnamed(path_));
  return unnamed ? QString() : QFileInfo(path_).completeBaseName();
}

/// The shelf does not list the project before it is first written.
void KeptProject::beginEmpty(const QString& folder) {
  shelf_.emplace(folder);
  path_ = shelf_->unnamedPath();
  lock_ = std::make_unique<ProjectLock>(path_);
  emit projectChanged();
}

bool KeptProject::begin(const QString& folder) {
  beginEmpty(folder);
  const QString last = shelf_->inUse();
  if (last.isEmpty()) return false;
  auto lock = std::make_unique<ProjectLock>(last);
  if (lock->inUse()) {
    emit noted(
        tr("%1. This is a new project.")
            .arg(whereOpen(last, shelf_->isUnnamed(last) ? tr("The last project") : QString())));
    return true;
  }
  // An unnamed project that was left empty has no file.
  if (shelf_->isUnnamed(last) && isAbsent(last)) {
    enter(last, std::move(lock), {});
    return true;
  }
  const bool crashed = lock->wasLeftBehind();
  lock.reset();
  if (open(last) && crashed && !project_.clips.empty())
    emit recovered(static_cast<int>(project_.clips.size()));
  return true;
}

bool KeptProject::isOutOfReach() const {
  return !project_.clips.empty() &&
         std::none_of(project_.clips.begin(), project_.clips.end(),
                      [](const ProjectClip& clip) { return QFileInfo::exists(clip.path); });
}

bool KeptProject::end() {
  if (ask_) ask_();
  if (!flush()) return false;
  try {
    if (shelf_ && !project_.isEmpty()) shelf_->use(path_);
  } catch (const Error& error) {
    setTrouble(QString::fromStdString(error.what()));
    return false;
  }
  path_.clear();
  lock_.reset();
  return true;
}

bool KeptProject::open(const QString& path) {
  const QString file = fileOf(path);
  if (file == path_) return true;
  if (!mayLeave()) return false;
  auto lock = std::make_unique<ProjectLock>(file);
  if (lock->inUse()) {
    emit inUse(file);
    return false;
  }
  if (shelf_ && (!lock->held() || !QFileInfo(file).isWritable())) {
    if (!openCopy(file)) return false;
    emit noted(
        tr("%1 is read-only. This is a copy without a name.").arg(QDir::toNativeSeparators(file)));
    return true;
  }
  try {
    return enter(file, std::move(lock), readProject(file));
  } catch (const Error& error) {
    emit failed(QString::fromStdString(error.what()));
    return false;
  }
}

bool KeptProject::openCopy(const QString& path) {
  if (!mayLeave()) return false;
  try {
    const QString own = shelf_->unnamedPath();
    auto lock = std::make_unique<ProjectLock>(own);
    const Project project = readProject(path);
    writeProject(own, project);
    return enter(own, std::move(lock), project);
  } catch (const Error& error) {
    emit failed(QString::fromStdString(error.what()));
    return false;
  }
}

bool KeptProject::startNew() {
  if (!mayLeave()) return false;
  if (!shelf_) return enter({}, nullptr, {});
  const QString path = shelf_->unnamedPath();
  return enter(path, std::make_unique<ProjectLock>(path), {});
}

/// Replaces the previous project, which must be in its file by now.
bool KeptProject::enter(const QString& path, std::unique_ptr<ProjectLock> lock, Project project) {
  try {
    if (shelf_) shelf_->use(path);
  } catch (const Error& error) {
    emit failed(QString::fromStdString(error.what()));
    return false;
  }
  const QString before = std::exchange(path_, QString());
  const bool was_empty = project_.isEmpty();
  emit leaving();
  if (was_empty) dropUnnamed(before);
  changed_ = unwritten_ = false;
  path_ = path;
  lock_ = std::move(lock);
  project_ = std::move(project);
  emit entered();
  emit projectChanged();
  return true;
}

bool KeptProject::saveAs(const QString& path) {
  const QString file = QFileInfo(path).absoluteFilePath();
  if (file == path_) {
    unwritten_ = true;
    return flush();
  }
  auto lock = std::make_unique<ProjectLock>(file);
  if (lock->inUse()) {
    emit failed(tr("%1.").arg(whereOpen(file)));
    return false;
  }
  // If the previous file cannot be written, an error says so, and the new file still has
  // everything. A project that was taken over is left as it is.
  if (lostLock())
    finishWriting();
  else
    flush();
  if (const QString trouble = keep(project_, file, shelf_, lock.get()); !trouble.isEmpty()) {
    emit failed(trouble);
    return false;
  }
  dropUnnamed(path_);
  path_ = file;
  lock_ = std::move(lock);
  changed_ = unwritten_ = false;
  trouble_.clear();
  emit projectChanged();
  emit saved();
  return true;
}

std::vector<FormerProject> KeptProject::formerProjects() const {
  std::vector<FormerProject> former;
  if (!shelf_) return former;
  for (const QString& path : shelf_->projects()) {
    if (path == path_) continue;
    if (former.size() == kMostFormer) break;
    FormerProject one{path, !shelf_->isUnnamed(path), QFileInfo(path).lastModified(), {}};
    try {
      one.clips = static_cast<int>(readProject(path).clips.size());
    } catch (const Error&) {
      // A project that cannot be read is listed all the same.
    }
    former.push_back(one);
  }
  return former;
}

void KeptProject::touch() {
  changed_ = unwritten_ = true;
  emit edited();
  writeSoon();
}

void KeptProject::writeSoon() {
  if (path_.isEmpty() || write_later_.isActive()) return;
  const std::chrono::milliseconds passed(since_write_.isValid() ? since_write_.elapsed()
                                                                : kWriteInterval.count());
  write_later_.start(std::max(kWriteInterval - passed, std::chrono::milliseconds(0)));
}

/// Writes on a thread of normal priority, unlike those of JobRunner: writing takes little work, and
/// the user may wait for it.
void KeptProject::write() {
  if (path_.isEmpty() || !changed_ || writing_.valid()) return;
  changed_ = false;
  since_write_.start();
  // The pointer stays valid: lock_ is kept until finishWriting().
  writing_ = std::async(std::launch::async, [this, project = project_, path = path_, shelf = shelf_,
                                             lock = lock_.get()] {
    const QString trouble = keep(project, path, shelf, lock);
    emit written(QPrivateSignal());
    return trouble;
  });
}

void KeptProject::noteWritten() {
  if (!writing_.valid()) return;  // flush() has taken the result
  const QString trouble = writing_.get();
  setTrouble(trouble);
  if (!trouble.isEmpty()) {
    changed_ = true;
    return write_later_.start(kRetryDelay);
  }
  unwritten_ = changed_;
  if (changed_)
    writeSoon();
  else
    emit saved();
}

bool KeptProject::mayLeave() {
  const QString obstacle = ask_ ? ask_() : QString();
  if (!obstacle.isEmpty()) emit failed(obstacle);
  return obstacle.isEmpty() && flush();
}

void KeptProject::finishWriting() {
  write_later_.stop();
  if (writing_.valid()) writing_.get();
}

/// Removes the file of a project without a name, unless it is another studio's now.
void KeptProject::dropUnnamed(const QString& path) {
  if (shelf_ && shelf_->isUnnamed(path) && !lostLock()) QFile::remove(path);
}

/// Writes everything that is pending. On failure it stays pending, and an error says so.
bool KeptProject::flush() {
  finishWriting();
  if (path_.isEmpty() || !unwritten_) return true;
  const QString trouble = keep(project_, path_, shelf_, lock_.get());
  changed_ = unwritten_ = !trouble.isEmpty();
  if (changed_) trouble_.clear();  // reports an error again, since the user asked to save
  setTrouble(trouble);
  if (changed_)
    write_later_.start(kRetryDelay);
  else
    emit saved();
  return !changed_;
}

/// Reports an error once, not with every attempt.
void KeptProject::setTrouble(const QString& message) {
  if (message == std::exchange(trouble_, message)) return;
  if (!message.isEmpty()) emit failed(tr("The project was not saved: %1").arg(message));
  emit projectChanged();
}

}  // namespace mocapress
