// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/jobs/clips.h"
#include "app/jobs/job_runner.h"

namespace mocapress {

/// Compresses a clip at several levels of visibility, for a blind test.
class LevelEncoder : public QObject {
  Q_OBJECT

 public:
  explicit LevelEncoder(QObject* parent = nullptr) : QObject(parent) {}

  /// Starts with the options of a clip, whose target, promises and ranges are ignored, and abandons
  /// a running task. Levels are multiples of the noticeable threshold.
  void start(std::shared_ptr<const Encoder> encoder, const EncodeSettings& options,
             const std::vector<double>& levels);
  void abandon() { runner_.abandon(); }

 signals:
  /// Emitted once for each level that the clip can reach, in the order of levels.
  void made(const DecodedPtr& decoded);
  void ended();

 private:
  JobRunner runner_;
};

}  // namespace mocapress
