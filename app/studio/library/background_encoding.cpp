// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/background_encoding.h"

#include <QThread>
#include <algorithm>
#include <chrono>
#include <utility>

#include "app/studio/batch/batch_session.h"
#include "app/studio/document/session.h"
#include "app/studio/library/library.h"

namespace mocapress {
namespace {

constexpr auto kWatchInterval = std::chrono::milliseconds(100);

/// Number of clips in a part: enough for all processors, and so few that clips which come into
/// sight start soon.
std::size_t part() {
  return 2 * static_cast<std::size_t>(std::max(QThread::idealThreadCount(), 2));
}

/// Makes a batch of the clips. Those whose settings name joints are read for that.
Batch batchOf(const std::vector<TunedClip>& clips) {
  Batch batch{.formats = {}};
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const QueuedClip queued = queuedClip(clips[i]);
    batch.presets.push_back(*queued.own);
    batch.items.push_back({.input = queued.source.path,
                           .skeleton = queued.skeleton,
                           .output = std::to_string(i),
                           .preset = i,
                           .reading = queued.reading});
  }
  return batch;
}

}  // namespace

BackgroundEncoding::BackgroundEncoding(Session* session, Library* library, QObject* parent)
    : QObject(parent), session_(session), library_(library) {
  watch_.setInterval(kWatchInterval);
  connect(&watch_, &QTimer::timeout, this, &BackgroundEncoding::look);
  connect(library, &Library::leaving, this, &BackgroundEncoding::leave);
  connect(&runner_, &BatchRunner::advanced, this,
          [this](const BatchCounts&, const std::vector<BatchStep>& steps) { take(steps); });
  connect(&runner_, &BatchRunner::failed, this, [this](const QString& message) {
    setActive(false);
    emit failed(message);
  });
}

void BackgroundEncoding::setActive(bool active) {
  if (active == active_) return;
  if (active && !folder_.isValid()) {
    emit failed(folder_.errorString());
    emit activeChanged(false);
    return;
  }
  active_ = active;
  if (active) {
    watch_.start();
    look();
  } else {
    watch_.stop();
    preparing_.abandon();
    runner_.pause();
  }
  emit activeChanged(active);
}

void BackgroundEncoding::look() {
  const bool yields = session_->busy();
  if (runner_.busy()) return yields ? runner_.pause() : runner_.goOn();
  if (yields || preparing_.busy()) return;
  if (const std::vector<TunedClip> next = library_->unencoded(part(), in_sight_()); !next.empty())
    begin(next);
}

void BackgroundEncoding::begin(const std::vector<TunedClip>& clips) {
  preparing_.start(
      [clips](const Job&) { return batchOf(clips); },
      [this, clips](const Batch& batch) {
        under_way_ = clips;
        runner_.start({batch, folder_.path(), {.overwrite = true, .largest_first = false}});
      },
      [this](const QString& message) {
        setActive(false);
        emit failed(message);
      });
}

void BackgroundEncoding::take(const std::vector<BatchStep>& steps) {
  for (const BatchStep& step : steps)
    if (step.ended && step.index < under_way_.size())
      library_->noteEncoded(under_way_[step.index], step);
}

/// Stops, and drops results that still arrive: the project with these clips is left.
void BackgroundEncoding::leave() {
  preparing_.abandon();
  runner_.cancel();
  under_way_.clear();
}

}  // namespace mocapress
