// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/codec/encode/slope.h"

namespace mocapress {

/// Changes of a clip's settings to try.
struct SlopeTask {
  /// Lets the error of these joints grow `times`-fold. Without joints, gives the motion `times` as
  /// many bytes.
  struct Change {
    std::vector<int> joints;
    double times = 2;
  };

  std::shared_ptr<const Encoder> encoder;
  EncodeSettings options;
  Standing now;
  std::vector<Change> changes;
};

/// Tries the changes of a task in the background, on one thread of the lowest priority.
class SlopeFinder : public QObject {
  Q_OBJECT

 public:
  explicit SlopeFinder(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts a task and abandons a running one.
  void start(const SlopeTask& task);
  void abandon() { runner_.abandon(); }
  bool busy() const { return runner_.busy(); }

 signals:
  /// `change`: an index in SlopeTask::changes.
  void found(int change, const Slope& slope);
  void ended();

 private:
  JobRunner runner_{Workers::Idle};
};

}  // namespace mocapress
