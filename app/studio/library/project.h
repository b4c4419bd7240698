// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QHash>
#include <QString>
#include <optional>
#include <vector>

#include "app/jobs/characters.h"
#include "app/studio/batch/batch_memory.h"
#include "app/studio/document/named_settings.h"
#include "core/batch/batch_difference.h"
#include "core/batch/row.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// A clip of a project with its settings and verdict.
struct ProjectClip {
  QString path;                           // absolute path
  QString skeleton;                       // for an .amc; empty: the one beside the clip
  ReadOptions reading;                    // import options of the user
  std::optional<NamedSettings> settings;  // unset: no settings of its own
  std::optional<Outcome> outcome;
  ClipReview review;
  bool notes_beside = false;  // the notes file beside the clip has notes on it
  std::vector<Pin> pins;
  std::string rig;   // rig_of() the skeleton when last read; empty: never read
  InputStamp stamp;  // stamp of its files when last examined; no hash: never examined
  std::optional<std::size_t> bytes_before;  // see LibraryEntry; not saved
  std::optional<ClipFigures> earlier;       // in the batch to compare with; not saved
  bool missing = false;                     // its files were gone when last looked for; not saved
  QString failure;  // why the settings cannot compress the clip; empty: unknown; not saved

  /// clipKey() of path and take. A file with several takes gets a clip for each once it has been
  /// read.
  QString key() const { return clipKey(path, reading.take); }
};

/// Hash of the clip's current settings and reading options; empty: no settings of its own.
std::string settingsHash(const ProjectClip& clip);

/// The reason why the verdict, or the outcome, does not apply to the clip today. None: it applies,
/// or there is none.
Staleness staleVerdict(const ProjectClip& clip);
Staleness outdated(const ProjectClip& clip);

/// The clip's changes since the batch to compare with. Unset: there is nothing to compare.
std::optional<ClipDifference> differenceSince(const ProjectClip& clip);

/// The reason, in English, why a note does not apply to the clip today. Unset: it applies.
std::optional<std::string> staleNote(const ProjectClip& clip, const FrameNote& note);

/// Gives a verdict the hash of the clip's files if it has none, because the clip was neither
/// compressed nor examined at the time. Does nothing if the files were written after the verdict.
void bindVerdict(ProjectClip& clip);

/// A list of clips with their common data.
struct Project {
  QString current;            // key of the open clip; empty: none
  CharacterFiles characters;  // characters put on the clips, by rig
  bool shows_skin = true;
  std::vector<ProjectClip> clips;
  std::optional<RememberedBatch> batch;  // unset: no batch yet

  ProjectClip* find(const QString& key);

  /// The first clip of that file, or null.
  ProjectClip* findFile(const QString& path);

  /// The row of each clip by its key.
  QHash<QString, int> rows() const;

  /// True if the project has neither clips nor a queue.
  bool isEmpty() const { return clips.empty() && (!batch || batch->clips.empty()); }
};

/// True for the extension .mocapress.
bool isProjectFile(const QString& path);

/// The project as JSON, with paths relative to its folder.
QByteArray projectText(const Project& project, const QDir& folder);

/// Throws Error with the reason.
Project parseProject(const QByteArray& text, const QDir& folder);

/// Throws Error that names the file.
Project readProject(const QString& path);

/// Replaces the file in one step, so that it always holds the old or the new project. Makes its
/// folder. Throws Error.
void writeProject(const QString& path, const Project& project);

}  // namespace mocapress
