// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <QTimer>
#include <vector>

#include "app/jobs/batch_runner.h"
#include "app/jobs/job_runner.h"
#include "app/studio/document/named_settings.h"

namespace mocapress {

class Library;
class Session;

/// Compresses the clips of the library by their settings, as a batch would, and keeps nothing but
/// what they come to. The queue is what Library::unencoded() says, taken up in small parts: a clip
/// whose settings change meanwhile is in a later part again, and its older result is dropped. It
/// waits while the session works for the clip that is open.
class BackgroundEncoding : public QObject {
  Q_OBJECT

 public:
  BackgroundEncoding(Session* session, Library* library, QObject* parent = nullptr);

  /// Begins or goes on; else pauses, in the middle of a clip too.
  void setActive(bool active);
  bool active() const { return active_; }

 signals:
  void activeChanged(bool active);
  void failed(const QString& message);

 private:
  void look();
  void begin(const std::vector<TunedClip>& clips);
  void take(const std::vector<BatchStep>& steps);
  void leave();

  Session* session_;
  Library* library_;
  bool active_ = false;
  QTimer watch_;                      // for clips that wait, and for the session's work
  QTemporaryDir folder_;              // the batch's journal is there; no clip is
  std::vector<TunedClip> under_way_;  // by their index in the batch
  JobRunner preparing_{Workers::LongRunning};
  BatchRunner runner_;
};

}  // namespace mocapress
