// SPDX-License-Identifier: GPL-3.0-or-later
// The files of clips, and whether they have changed.

#pragma once

#include <QString>
#include <map>
#include <vector>

#include "app/jobs/job_runner.h"
#include "core/batch/row.h"

namespace mocapress {

/// A clip's files and their stamp when last examined.
struct ClipSource {
  QString path;
  QString skeleton;  // for an .amc; empty: the one beside the clip
  InputStamp stamp;  // no hash: never examined
};

/// The files of a ClipSource as they are now.
struct SourceNow {
  enum class State { Found, Missing, Unreadable };

  State state = State::Found;
  InputStamp stamp;  // stamp of the files found
  QString trouble;   // error if they cannot be read
};

/// Examines a clip's files. Reads their bytes only if sizes or times have changed.
SourceNow lookAt(const ClipSource& source);

/// Examines many clips, in order. Returns fewer if the job is stopped.
std::vector<SourceNow> lookAt(const std::vector<ClipSource>& sources, const Job& job);

/// Searches a folder for missing clips by their file names. Among several files with the same name,
/// the one with the clip's old bytes wins; a file with other bytes is taken only if it is the only
/// one. The result is keyed by the paths of the missing clips.
std::map<QString, ClipSource> findMoved(const QString& folder,
                                        const std::vector<ClipSource>& missing, const Job& job);

}  // namespace mocapress
