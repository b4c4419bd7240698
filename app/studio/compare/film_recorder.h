// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QObject>
#include <QProcess>
#include <QTemporaryDir>
#include <functional>
#include <memory>

#include "app/jobs/job_runner.h"

namespace mocapress {

class Viewport;

/// A sequence of pictures of the 3D view.
struct Film {
  int pictures = 0;
  double rate_hz = 30;
  std::function<void(int picture)> arrange;  // sets the view up for a picture
};

/// Takes the pictures of a film and writes them: as numbered PNGs into a folder named after the
/// path if it ends with .png, else as a video by ffmpeg. Everything is written beside the final
/// path and renamed at the end, so that a failure or a cancel leaves nothing half-written.
class FilmRecorder : public QObject {
  Q_OBJECT

 public:
  explicit FilmRecorder(Viewport* viewport, QObject* parent = nullptr);

  /// Starts recording; finished(), failed() or cancel() ends it.
  void record(const Film& film, const QString& path);
  void cancel();

  bool busy() const { return stage_ != Stage::Idle; }

  /// The program that writes videos; empty: it is not installed.
  static QString ffmpeg();

 signals:
  void progressed(int pictures);
  void encoding();  // all pictures are taken, and the video is made of them
  void finished(const QString& path);
  void failed(const QString& message);

 private:
  enum class Stage { Idle, Pictures, Video };

  void takeNext();
  void keep(const QImage& image);
  void encodeVideo();
  void finish(const QString& from, const QString& to);
  void fail(const QString& message);
  void reset();

  Viewport* viewport_;
  Film film_;
  QString path_;
  Stage stage_ = Stage::Idle;
  int next_ = 0;
  bool waits_for_picture_ = false;
  std::unique_ptr<QTemporaryDir> folder_;
  QProcess video_;
  JobRunner writing_{Workers::LongRunning};
};

}  // namespace mocapress
