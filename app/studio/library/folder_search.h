// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>

#include "app/jobs/job_runner.h"

namespace mocapress {

/// Finds the clips below folders in the background, one folder after the other.
class FolderSearch : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  void search(const QString& folder);

  /// Stops the search; nothing more is found.
  void abandon();

 signals:
  /// Motion files found below a folder.
  void found(const QStringList& clips);
  void failed(const QString& message);

 private:
  void searchNext();

  QStringList folders_;  // still to be searched
  JobRunner finding_{Workers::LongRunning};
};

}  // namespace mocapress
