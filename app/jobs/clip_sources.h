// SPDX-License-Identifier: GPL-3.0-or-later
// The files that clips are read from, and whether they still are what they were.

#pragma once

#include <QString>
#include <map>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/batch/row.h"

namespace mocapress {

/// A clip's files, and what they were when they were looked at last.
struct ClipSource {
  QString path;
  QString skeleton;  // for an .amc; empty: the one beside it
  InputStamp stamp;  // no hash: they were never looked at
};

/// The same files as they are now.
struct SourceNow {
  enum class State { Found, Missing, Unreadable };

  State state = State::Found;
  InputStamp stamp;  // where they were found
  QString trouble;   // where they cannot be read
};

/// Bytes are only read where sizes or times have changed.
SourceNow lookAt(const ClipSource& source);

/// The same for many clips, in their order; fewer where the job is to stop.
std::vector<SourceNow> lookAt(const std::vector<ClipSource>& sources, const Job& job);

/// Looks for clips below a folder, by the names of their files. Where several files have a name, it
/// is the one with the bytes that the clip had; one with other bytes is taken only where it is the
/// only one. By the paths of the clips that were found.
std::map<QString, ClipSource> findMoved(const QString& folder,
                                        const std::vector<ClipSource>& missing, const Job& job);

}  // namespace mocapress
