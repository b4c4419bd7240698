// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/study/study_status.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "app/studio/study/study_session.h"

namespace mocapress {
namespace {

struct Status {
  Q_DECLARE_TR_FUNCTIONS(mocapress::StudyStatus)
};

constexpr int kFirstEstimate = 3;  // rows measured before the time left is guessed

/// "0:42", "1:05:10".
QString clockText(double seconds) {
  const auto whole = static_cast<int>(std::lround(seconds));
  const auto two = [](int number) { return QStringLiteral("%1").arg(number, 2, 10, QChar(u'0')); };
  const QString rest = two(whole % 60);
  if (whole < 3600) return QStringLiteral("%1:%2").arg(whole / 60).arg(rest);
  return QStringLiteral("%1:%2:%3").arg(whole / 3600).arg(two(whole / 60 % 60), rest);
}

QString asked(const StudySession& session) {
  const int jobs = session.jobs();
  if (jobs == 0) return hintOf(session);
  return Status::tr("%Ln compression(s) to run", nullptr, jobs);
}

QString running(const StudySession& session) {
  const StudyCounts& counts = session.counts();
  const QString so_far = Status::tr("%L1 of %L2").arg(counts.done).arg(counts.jobs);
  const int anew = counts.done - counts.kept;
  if (anew < kFirstEstimate || counts.done == counts.jobs) return so_far;
  const double left = session.elapsedSeconds() / anew * (counts.jobs - counts.done);
  return Status::tr("%1, about %2 left").arg(so_far, clockText(left));
}

/// What could not be measured.
QString blemishes(const StudySession& session) {
  int unread = 0;
  int missed = 0;
  for (const StudyRow& row : session.rows())
    if (!row.measured) ++(row.fingerprint.empty() ? unread : missed);
  QString text;
  if (missed > 0) text += Status::tr(", %Ln out of reach", nullptr, missed);
  if (unread > 0) text += Status::tr(", %Ln of clips that cannot be read", nullptr, unread);
  return text;
}

QString complete(const StudySession& session) {
  const auto rows = static_cast<int>(session.rows().size());
  return Status::tr("%Ln compression(s)%1", nullptr, rows).arg(blemishes(session));
}

}  // namespace

QString statusOf(const StudySession& session) {
  if (session.exporting()) return Status::tr("Writing…");
  switch (session.state()) {
    case StudySession::State::Idle:
      return asked(session);
    case StudySession::State::Running:
      return running(session);
    case StudySession::State::Drawing:
      return Status::tr("Drawing the report…");
    case StudySession::State::Complete:
    case StudySession::State::Opened:
      return complete(session);
    case StudySession::State::Cancelled:
      return Status::tr("Cancelled after %L1 of %L2; the next run continues from there")
          .arg(session.counts().done)
          .arg(session.counts().jobs);
    case StudySession::State::Failed:
      return session.failure();
  }
  return {};
}

QString hintOf(const StudySession& session) {
  const StudySettings& settings = session.settings();
  if (settings.clips.isEmpty()) return Status::tr("Add a clip to study");
  if (settings.methods.isEmpty()) return Status::tr("Check a method to study");
  if (settings.ratios.empty() && settings.errors.empty())
    return Status::tr("Name a ratio or an error to reach");
  return session.running() ? Status::tr("Measuring…") : Status::tr("Run the study to see curves");
}

}  // namespace mocapress
