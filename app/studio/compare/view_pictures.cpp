// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/compare/view_pictures.h"

#include <QBuffer>
#include <QClipboard>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QProgressDialog>
#include <QtMath>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/document/session.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "widgets/timeline/playback.h"
#include "widgets/viewport/viewport.h"

namespace mocapress {
namespace {

constexpr double kMostPictures = 30;  // per second: what players and eyes are used to
constexpr int kTurnSeconds = 4;

/// Throws WriteError.
void writePicture(const QImage& image, const QString& path) {
  QBuffer file;
  file.open(QIODevice::WriteOnly);
  image.save(&file, "PNG");
  write_text(path.toStdU16String(), file.data().toStdString());
}

}  // namespace

ViewPictures::ViewPictures(Session* session, Playback* playback, Viewport* viewport,
                           QWidget* window)
    : QObject(window),
      session_(session),
      playback_(playback),
      viewport_(viewport),
      window_(window),
      recorder_(new FilmRecorder(viewport, this)) {
  connect(viewport, &Viewport::captured, this, [this](const QImage& image) {
    if (on_picture_.empty()) return;
    const auto then = std::move(on_picture_.front());
    on_picture_.pop_front();
    then(image);
    if (!on_picture_.empty()) viewport_->capture();
  });
  connect(recorder_, &FilmRecorder::progressed, this, [this](int pictures) {
    if (progress_) progress_->setValue(pictures);
  });
  connect(recorder_, &FilmRecorder::encoding, this, [this] {
    if (progress_) progress_->setLabelText(tr("Making the video…"));
  });
  connect(recorder_, &FilmRecorder::finished, this, [this](const QString& path) {
    end();
    emit noted(tr("Wrote %1.").arg(QFileInfo(path).fileName()));
  });
  connect(recorder_, &FilmRecorder::failed, this, [this](const QString& message) {
    end();
    emit failed(message);
  });
}

ViewPictures::~ViewPictures() {
  saving_.finish();
  if (saving_.busy()) unwritten_.pop_front();  // written, but its job has not reported yet
  for (const auto& [image, path] : unwritten_) try {
      writePicture(image, path);
    } catch (const Error&) {
      // Nobody is left to see an error.
    }
}

void ViewPictures::take(std::function<void(const QImage&)> then) {
  if (recorder_->busy()) return;
  on_picture_.emplace_back([this, then = std::move(then)](const QImage& image) {
    image.isNull() ? emit failed(tr("The 3D view gave no picture.")) : then(image);
  });
  if (on_picture_.size() == 1) viewport_->capture();  // the view takes one picture at a time
}

void ViewPictures::copy() {
  take([this](const QImage& image) {
    QGuiApplication::clipboard()->setImage(image);
    emit noted(tr("Copied the picture of the view."));
  });
}

QString ViewPictures::choosePlace(const QString& title, const QString& filters,
                                  const QString& extension) {
  const OriginalPtr& original = session_->document().original();
  const QFileInfo clip(original ? original->path : session_->document().savedPath());
  const QString suggestion =
      clip.dir().filePath(clip.completeBaseName() + QLatin1Char('.') + extension);
  return QFileDialog::getSaveFileName(window_, title, suggestion, filters);
}

void ViewPictures::choosePicture() {
  QString path = choosePlace(tr("Save Picture"), tr("Pictures (*.png)"), QStringLiteral("png"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".png");
  savePicture(path);
}

void ViewPictures::savePicture(const QString& path) {
  take([this, path](const QImage& image) {
    unwritten_.emplace_back(image, path);
    writeNext();
  });
}

void ViewPictures::writeNext() {
  if (unwritten_.empty() || saving_.busy()) return;
  const auto go_on = [this] {
    unwritten_.pop_front();
    writeNext();
  };
  saving_.start(
      [next = unwritten_.front()](const Job&) {
        writePicture(next.first, next.second);
        return QFileInfo(next.second).fileName();
      },
      [this, go_on](const QString& name) {
        go_on();
        emit noted(tr("Wrote %1.").arg(name));
      },
      [this, go_on](const QString& message) {
        go_on();
        emit failed(message);
      });
}

void ViewPictures::chooseFilm() {
  chooseFilmPlace(tr("Film of the Range"), &ViewPictures::film);
}

void ViewPictures::chooseTurntable() {
  chooseFilmPlace(tr("Turntable"), &ViewPictures::turntable);
}

void ViewPictures::chooseFilmPlace(const QString& title,
                                   void (ViewPictures::*write)(const QString&)) {
  const QString extension =
      FilmRecorder::ffmpeg().isEmpty() ? QStringLiteral("png") : QStringLiteral("mp4");
  const QString videos = tr("Videos (*.mp4 *.webm *.gif)");
  const QString pictures = tr("Numbered pictures in a folder (*.png)");
  const bool has_ffmpeg = extension == QLatin1String("mp4");
  QString path = choosePlace(title,
                             has_ffmpeg ? videos + QStringLiteral(";;") + pictures
                                        : pictures + QStringLiteral(";;") + videos,
                             extension);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QLatin1Char('.') + extension;
  (this->*write)(path);
}

void ViewPictures::film(const QString& path) {
  if (playback_->frames() == 0) return;
  const auto [first, last] = playback_->range().value_or(std::pair(0, playback_->frames() - 1));
  const double rate = std::min(kMostPictures, playback_->sampleRate());
  const double apart = playback_->sampleRate() / rate;  // frames from picture to picture
  const int pictures = 1 + static_cast<int>((last - first) / apart);
  const auto show = [this, first = first, apart](int picture) {
    playback_->seek(first + static_cast<int>(std::lround(picture * apart)));
  };
  playback_->pause();
  restore_ = [this, frame = playback_->frame()] { playback_->seek(frame); };
  record({pictures, rate, show}, path);
}

void ViewPictures::turntable(const QString& path) {
  if (playback_->frames() == 0) return;
  const int pictures = static_cast<int>(kTurnSeconds * kMostPictures);
  playback_->pause();
  // Turns the camera back. Setting its place would count as the user's choice.
  restore_ = [this, before = viewport_->camera().place()] {
    const float turned = viewport_->camera().place().azimuth - before.azimuth;
    viewport_->turnCamera(-qRadiansToDegrees(static_cast<double>(turned)));
  };
  const auto turn = [this](int picture) {
    if (picture > 0) viewport_->turnCamera(360.0 / pictures);
  };
  record({pictures, kMostPictures, turn}, path);
}

void ViewPictures::record(const Film& film, const QString& path) {
  if (recorder_->busy()) return;
  progress_ = new QProgressDialog(tr("Taking %Ln picture(s)…", nullptr, film.pictures),
                                  tr("Cancel"), 0, film.pictures, window_);
  progress_->setWindowTitle(QFileInfo(path).fileName());
  progress_->setWindowModality(Qt::WindowModal);  // the user must not change the view
  progress_->setAutoClose(false);
  progress_->setAutoReset(false);
  progress_->setMinimumDuration(0);
  connect(progress_, &QProgressDialog::canceled, this, [this] {
    recorder_->cancel();
    end();
  });
  recorder_->record(film, path);
}

void ViewPictures::end() {
  if (progress_) std::exchange(progress_, nullptr)->deleteLater();
  if (const auto restore = std::exchange(restore_, {})) restore();
}

}  // namespace mocapress
