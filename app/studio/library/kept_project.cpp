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

#include "core/base/error.h"
#include "core/base/path_kind.h"

namespace mocapress {

namespace {

constexpr int kHalfMade = 1000;  // ms after which a lock without an owner counts as abandoned

}  // namespace

ProjectLock::ProjectLock(const QString& project)
    : existed_(QFile::exists(fileOf(project))), lock_(fileOf(project)) {
  // Age does not matter: a lock is abandoned only when its process is gone.
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

/// True if the file certainly does not exist. If the system cannot tell, opening the file will.
bool isAbsent(const QString& path) {
  try {
    return !is_there(path.toStdU16String());
  } catch (const Error&) {
    return false;
  }
}

/// Writes the project and returns the error; empty: none. The next start opens the project that was
/// written last, in whichever window.
QString keep(const Project& project, const QString& path,
             const std::optional<ProjectShelf>& shelf) {
  try {
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

/// The shelf learns of the project once something is in it.
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
    emit noted(tr("%1 is open in another window of Mocapress. This is a new project.")
                   .arg(shelf_->isUnnamed(last) ? tr("The last project")
                                                : QDir::toNativeSeparators(last)));
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

/// The previous project is in its file by now.
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
  if (shelf_ && was_empty && shelf_->isUnnamed(before)) QFile::remove(before);
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
    emit failed(
        tr("%1 is open in another window of Mocapress.").arg(QDir::toNativeSeparators(file)));
    return false;
  }
  // If the previous file cannot be written, an error says so, and the new file still has
  // everything.
  flush();
  if (const QString trouble = keep(project_, file, shelf_); !trouble.isEmpty()) {
    emit failed(trouble);
    return false;
  }
  if (shelf_ && shelf_->isUnnamed(path_)) QFile::remove(path_);
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
      // The project is in its file all the same.
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

/// Writes on a thread of normal priority, unlike a JobRunner's: it works little and may be waited
/// for.
void KeptProject::write() {
  if (path_.isEmpty() || !changed_ || writing_.valid()) return;
  changed_ = false;
  since_write_.start();
  writing_ =
      std::async(std::launch::async, [this, project = project_, path = path_, shelf = shelf_] {
        const QString trouble = keep(project, path, shelf);
        emit written(QPrivateSignal());
        return trouble;
      });
}

void KeptProject::noteWritten() {
  if (!writing_.valid()) return;  // flush() has handled it
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

/// Writes everything that is pending. On failure it stays pending, and an error says so.
bool KeptProject::flush() {
  write_later_.stop();
  if (writing_.valid()) writing_.get();
  if (path_.isEmpty() || !unwritten_) return true;
  const QString trouble = keep(project_, path_, shelf_);
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
