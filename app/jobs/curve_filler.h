// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/codec/encode/encoder.h"
#include "core/report/curve.h"

namespace mocapress {

/// Points of a rate-distortion curve to measure.
struct CurveTask {
  std::shared_ptr<const Encoder> encoder;
  EncodeSettings options;      // their target is ignored
  std::vector<double> ratios;  // in order of priority
};

/// Measures a clip at several ratios in the background, on one thread of the lowest priority.
class CurveFiller : public QObject {
  Q_OBJECT

 public:
  explicit CurveFiller(QObject* parent = nullptr);

  /// Starts a task and abandons a running one.
  void start(const CurveTask& task);
  void abandon() { runner_.abandon(); }
  bool busy() const { return runner_.busy(); }

 signals:
  /// `asked`: the ratio in the task that led to this point.
  void measured(double asked, const CurvePoint& point);
  void ended();

 private:
  JobRunner runner_{Workers::Idle};
};

}  // namespace mocapress
