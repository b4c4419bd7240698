// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/curve_filler.h"

#include "core/base/error.h"
#include "core/base/one_thread.h"
#include "core/metrics/rate.h"

namespace mocapress {

CurveFiller::CurveFiller(QObject* parent) : QObject(parent) {}

void CurveFiller::start(const CurveTask& task) {
  const auto work = [this, task](const Job& job) {
    for (const double ratio : task.ratios) {
      if (job.stopRequested()) break;
      EncodeSettings options = task.options;
      options.target = {Target::Kind::Ratio, ratio};
      on_one_thread([&] {
        try {
          const Encoding encoding = task.encoder->encode(
              options, [&job](const EncodeProgress&) { return !job.stopRequested(); });
          if (!encoding.complete) return;
          const CurvePoint point{
              compression_ratio(encoding.decoded, encoding.compressed.motion_bytes()),
              encoding.distortion.eps(options.weighting)};
          job.post([this, ratio, point] { emit measured(ratio, point); });
        } catch (const Error&) {
          // The clip cannot reach this ratio: the curve has no point there.
        }
      });
    }
    return true;
  };
  runner_.start(
      work, [this](bool) { emit ended(); }, [this](const QString&) { emit ended(); });
}

}  // namespace mocapress
