// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/batch/batch_status.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/studio/batch/batch_session.h"

namespace mocapress {
namespace {

using State = BatchSession::State;

struct Status {
  Q_DECLARE_TR_FUNCTIONS(mocapress::BatchStatus)
};

/// "0:42", "1:05:10".
QString clockText(double seconds) {
  const auto whole = static_cast<int>(std::lround(seconds));
  const auto two = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QChar(u'0')); };
  const QString rest = two(whole % 60);
  if (whole < 3600) return QStringLiteral("%1:%2").arg(whole / 60).arg(rest);
  return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(two(whole / 60 % 60), rest);
}

QString failedText(std::size_t failed) {
  if (failed == 0) return {};
  return Status::tr(", %Ln failed", nullptr, static_cast<int>(failed));
}

QString leftOutText(const BatchQueueModel& queue) {
  if (queue.countLeftOut() == 0) return {};
  return Status::tr(", %Ln left out", nullptr, queue.countLeftOut());
}

QString warnedText(const BatchQueueModel& queue) {
  const auto warned =
      std::count_if(queue.clips().begin(), queue.clips().end(), [](const QueuedClip& clip) {
        return clip.state == QueuedClip::State::Done && !clip.left_out && !clip.warnings.empty();
      });
  if (warned == 0) return {};
  return Status::tr(", %Ln with warnings", nullptr, static_cast<int>(warned));
}

QString soFar(const BatchCounts& counts) {
  return Status::tr("%L1 of %L2").arg(counts.done).arg(counts.clips) + failedText(counts.failed);
}

QString running(const BatchSession& session) {
  const auto left = session.secondsLeft();
  if (!left || session.counts().done == session.counts().clips) return soFar(session.counts());
  return Status::tr("%1, about %2 left").arg(soFar(session.counts()), clockText(*left));
}

QString idle(const BatchSession& session) {
  const BatchQueueModel& queue = *session.queue();
  const int waiting =
      queue.count(QueuedClip::State::Waiting) + queue.count(QueuedClip::State::Failed);
  if (!session.obstacle().isEmpty()) return session.obstacle();
  return Status::tr("%Ln clip(s) to export", nullptr, waiting) + leftOutText(queue);
}

QString complete(const BatchSession& session) {
  const BatchCounts& counts = session.counts();
  const auto done = static_cast<int>(counts.done - counts.failed);
  return Status::tr("%Ln clip(s) exported and verified", nullptr, done) +
         warnedText(*session.queue()) + failedText(counts.failed) + leftOutText(*session.queue());
}

}  // namespace

QString statusOf(const BatchSession& session) {
  switch (session.state()) {
    case State::Idle:
      return idle(session);
    case State::Running:
      return running(session);
    case State::Paused:
      return Status::tr("Paused at %1").arg(soFar(session.counts()));
    case State::Stopping:
      return Status::tr("Stopping after the current clips: %1").arg(soFar(session.counts()));
    case State::Cancelling:
      return Status::tr("Cancelling…");
    case State::Stopped:
      return Status::tr("Stopped at %1; the next start continues from there")
          .arg(soFar(session.counts()));
    case State::Complete:
      return complete(session);
    case State::Failed:
      return session.failure();
  }
  return {};
}

QString startText(const BatchSession& session) {
  if (session.state() == State::Paused) return Status::tr("&Go On");
  if (session.running()) return Status::tr("&Pause");
  const int waiting = session.queue()->count(QueuedClip::State::Waiting);
  const int failed = session.queue()->count(QueuedClip::State::Failed);
  if (waiting == 0 && failed > 0) return Status::tr("&Retry %Ln Failed", nullptr, failed);
  return session.state() == State::Stopped ? Status::tr("&Go On") : Status::tr("&Export");
}

}  // namespace mocapress
