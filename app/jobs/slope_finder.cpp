// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/jobs/slope_finder.h"

#include "core/base/error.h"
#include "core/base/one_thread.h"

namespace mocapress {

void SlopeFinder::start(const SlopeTask& task) {
  const auto work = [this, task](const Job& job) {
    const auto goes_on = [&job](const EncodeProgress&) { return !job.stopRequested(); };
    for (std::size_t i = 0; i < task.changes.size() && !job.stopRequested(); ++i)
      on_one_thread([&] {
        const SlopeTask::Change& change = task.changes[i];
        try {
          const Slope slope = change.joints.empty() ? resize(*task.encoder, task.options, task.now,
                                                             change.times, goes_on)
                                                    : relax(*task.encoder, task.options, task.now,
                                                            change.joints, change.times, goes_on);
          if (job.stopRequested()) return;
          job.post([this, i, slope] { emit found(static_cast<int>(i), slope); });
        } catch (const Error&) {
          // The clip cannot reach this change: it gets no line.
        }
      });
    return true;
  };
  runner_.start(
      work, [this](bool) { emit ended(); }, [this](const QString&) { emit ended(); });
}

}  // namespace mocapress
