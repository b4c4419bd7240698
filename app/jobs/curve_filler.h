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
  EncodeSettings options;      // but for the target
  std::vector<double> ratios;  // in the order in which they are wanted
};

/// Measures a clip at several ratios in the background: on one thread that gives way to all others.
class CurveFiller : public QObject {
  Q_OBJECT

 public:
  explicit CurveFiller(QObject* parent = nullptr);

  /// Abandons a running one.
  void start(const CurveTask& task);
  void abandon() { runner_.abandon(); }
  bool busy() const { return runner_.busy(); }

 signals:
  /// `asked` is the ratio of the task that gave the point.
  void measured(double asked, const CurvePoint& point);
  void ended();

 private:
  JobRunner runner_{Workers::Idle};
};

}  // namespace mocapress
