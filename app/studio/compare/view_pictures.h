// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <deque>
#include <functional>
#include <utility>

#include "app/jobs/job_runner.h"
#include "app/studio/compare/film_recorder.h"

class QProgressDialog;
class QWidget;

namespace mocapress {

class Playback;
class Session;
class Viewport;

/// Pictures and films of the 3D view as it is set up: with its ways to compare, its colours and
/// titles.
class ViewPictures : public QObject {
  Q_OBJECT

 public:
  ViewPictures(Session* session, Playback* playback, Viewport* viewport, QWidget* window);

  /// Writes the pictures that still wait to be written.
  ~ViewPictures() override;

  void copy();
  void choosePicture();
  void savePicture(const QString& path);

  void chooseFilm();
  void chooseTurntable();

  /// Films the chosen range, or else the whole clip, at its own pace.
  void film(const QString& path);

  /// Films the shown frame while the camera turns round it once.
  void turntable(const QString& path);

 signals:
  void noted(const QString& note);
  void failed(const QString& message);

 private:
  void take(std::function<void(const QImage&)> then);
  void writeNext();
  QString choosePlace(const QString& title, const QString& filters, const QString& extension);
  void chooseFilmPlace(const QString& title, void (ViewPictures::*write)(const QString&));
  void record(const Film& film, const QString& path);
  void end();

  Session* session_;
  Playback* playback_;
  Viewport* viewport_;
  QWidget* window_;
  FilmRecorder* recorder_;
  QProgressDialog* progress_ = nullptr;
  std::function<void()> restore_;                              // undoes what a film changed
  std::deque<std::function<void(const QImage&)>> on_picture_;  // wait for their pictures
  std::deque<std::pair<QImage, QString>> unwritten_;           // the first is being written
  JobRunner saving_{Workers::LongRunning};
};

}  // namespace mocapress
