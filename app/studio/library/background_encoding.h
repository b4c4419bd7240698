// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTemporaryDir>
#include <QTimer>
#include <functional>
#include <utility>
#include <vector>

#include "app/jobs/batch_runner.h"
#include "app/jobs/job_runner.h"
#include "app/studio/document/named_settings.h"

namespace mocapress {

class Library;
class Session;

/// Compresses the clips of the library by their settings, as a batch would, and keeps only the
/// measurements. Takes the clips of Library::unencoded() in small parts, those in sight first. If a
/// clip's settings change meanwhile, its result is dropped and a later part has the clip again.
/// Waits while the session works on the open clip.
class BackgroundEncoding : public QObject {
  Q_OBJECT

 public:
  BackgroundEncoding(Session* session, Library* library, QObject* parent = nullptr);

  /// True starts or resumes; false pauses, also in the middle of a clip.
  void setActive(bool active);
  bool active() const { return active_; }

  /// Returns the rows of clips that the user sees.
  using InSight = std::function<std::vector<int>()>;
  void setInSight(InSight in_sight) { in_sight_ = std::move(in_sight); }

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
  InSight in_sight_ = [] { return std::vector<int>(); };
  bool active_ = false;
  QTimer watch_;          // looks for waiting clips, and for the end of the session's work
  QTemporaryDir folder_;  // holds the batch's journal, but no clips
  std::vector<TunedClip> under_way_;  // by their index in the batch
  JobRunner preparing_{Workers::LongRunning};
  BatchRunner runner_;
};

}  // namespace mocapress
