// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <deque>

#include "app/jobs/clip_outline.h"
#include "app/jobs/job_runner.h"

namespace mocapress {

struct Project;

/// Reads the outlines of a project's clips in the background, one after the other.
class OutlineReader : public QObject {
  Q_OBJECT

 public:
  explicit OutlineReader(Project* project) : project_(project) {}

  /// Queues the clip with that ProjectClip::key(). When its turn comes, it is read by the project's
  /// present settings, or left out if the project no longer has it.
  void add(const QString& key);

  /// Empties the queue; the clip that is being read is still delivered.
  void clear() { unread_.clear(); }

 signals:
  /// `trouble`: the reason why the clip could not be read; empty: it was read.
  void read(const QString& key, const ClipOutline& outline, const QString& trouble);

 private:
  void readNext();

  Project* project_;
  std::deque<QString> unread_;
  JobRunner reading_{Workers::LongRunning};
};

}  // namespace mocapress
