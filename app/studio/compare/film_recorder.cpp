// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/film_recorder.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <filesystem>

#include "core/base/error.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

bool isSequence(const QString& path) {
  return path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive);
}

/// The folder of a sequence: walk for walk.png.
QString folderOf(const QString& path) {
  const QFileInfo info(path);
  return info.dir().filePath(info.completeBaseName());
}

QString numbered(const QString& base, int picture) {
  return QStringLiteral("%1_%2.png").arg(base).arg(picture + 1, 4, 10, QLatin1Char('0'));
}

std::filesystem::path native(const QString& path) {
  return path.toStdU16String();
}

}  // namespace

FilmRecorder::FilmRecorder(Viewport* viewport, QObject* parent)
    : QObject(parent), viewport_(viewport) {
  connect(viewport, &Viewport::captured, this, [this](const QImage& image) {
    if (std::exchange(waits_for_picture_, false)) keep(image);
  });
  connect(&video_, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
    if (stage_ != Stage::Video) return;
    if (status == QProcess::NormalExit && code == 0)
      return finish(folder_->filePath(QStringLiteral("film.") + QFileInfo(path_).suffix()), path_);
    const QStringList lines =
        QString::fromLocal8Bit(video_.readAllStandardError()).trimmed().split(QLatin1Char('\n'));
    fail(tr("%1: ffmpeg could not write the video (%2)").arg(path_, lines.last().trimmed()));
  });
  connect(&video_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (stage_ == Stage::Video && error == QProcess::FailedToStart)  // no finished() follows
      fail(tr("%1: ffmpeg could not write the video (%2)").arg(path_, video_.errorString()));
  });
}

QString FilmRecorder::ffmpeg() {
  return QStandardPaths::findExecutable(QStringLiteral("ffmpeg"));
}

void FilmRecorder::record(const Film& film, const QString& path) {
  if (busy()) return;
  if (!isSequence(path) && ffmpeg().isEmpty())
    return fail(
        tr("A video needs the program ffmpeg, which is not installed here. Numbered "
           "pictures (.png) need nothing."));
  if (isSequence(path) && QFileInfo::exists(folderOf(path)))
    return fail(tr("%1: there is such a folder already").arg(folderOf(path)));
  folder_ = std::make_unique<QTemporaryDir>(path + QStringLiteral(".XXXXXX"));
  if (!folder_->isValid())
    return fail(tr("%1: cannot be written (%2)").arg(path, folder_->errorString()));
  film_ = film;
  path_ = path;
  next_ = 0;
  stage_ = Stage::Pictures;
  takeNext();
}

void FilmRecorder::takeNext() {
  if (stage_ != Stage::Pictures) return;
  emit progressed(next_);
  if (stage_ != Stage::Pictures) return;  // cancelled
  if (next_ == film_.pictures) return encodeVideo();
  film_.arrange(next_);
  waits_for_picture_ = true;
  viewport_->capture();
}

void FilmRecorder::keep(const QImage& image) {
  if (image.isNull()) return fail(tr("The 3D view gave no picture."));
  const QString file = folder_->filePath(numbered(QFileInfo(path_).completeBaseName(), next_++));
  writing_.start(
      [image, file](const Job&) {
        if (!image.save(file)) throw WriteError(file.toStdString() + ": cannot be written");
        return true;
      },
      [this](bool) { takeNext(); }, [this](const QString& message) { fail(message); });
}

void FilmRecorder::encodeVideo() {
  if (isSequence(path_)) return finish(folder_->path(), folderOf(path_));
  stage_ = Stage::Video;
  emit encoding();
  const QString base = QFileInfo(path_).completeBaseName();
  video_.setWorkingDirectory(folder_->path());
  // ffmpeg would replace a % in the name by a number, and take a name with : for a protocol.
  const QString pictures = QStringLiteral("./") +
                           QString(base).replace(QLatin1Char('%'), QStringLiteral("%%")) +
                           QStringLiteral("_%04d.png");
  video_.start(ffmpeg(),
               {QStringLiteral("-v"), QStringLiteral("error"), QStringLiteral("-framerate"),
                QString::number(film_.rate_hz), QStringLiteral("-start_number"),
                QStringLiteral("1"), QStringLiteral("-i"), pictures,
                // Players want even sizes, and colours at half the resolution.
                QStringLiteral("-vf"), QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2"),
                QStringLiteral("-pix_fmt"), QStringLiteral("yuv420p"),
                QStringLiteral("film.") + QFileInfo(path_).suffix()});
}

void FilmRecorder::finish(const QString& from, const QString& to) {
  std::error_code error;
  std::filesystem::rename(native(from), native(to), error);
  if (error)
    return fail(tr("%1: cannot be written (%2)").arg(to, QString::fromStdString(error.message())));
  if (isSequence(path_)) folder_->setAutoRemove(false);
  reset();
  emit finished(to);
}

void FilmRecorder::fail(const QString& message) {
  reset();
  emit failed(message);
}

void FilmRecorder::cancel() {
  if (busy()) reset();
}

void FilmRecorder::reset() {
  stage_ = Stage::Idle;
  waits_for_picture_ = false;
  writing_.abandon();
  writing_.finish();  // before its folder is removed
  if (video_.state() != QProcess::NotRunning) {
    video_.kill();
    video_.waitForFinished();
  }
  folder_.reset();
}

}  // namespace mocapress
