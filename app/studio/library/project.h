// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QString>
#include <optional>
#include <vector>

#include "app/jobs/characters.h"
#include "app/studio/batch/batch_memory.h"
#include "app/studio/document/named_settings.h"
#include "core/batch/row.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// A clip of a project, and all that was decided about it.
struct ProjectClip {
  QString path;                           // absolute
  QString skeleton;                       // for an .amc; empty: the one beside it
  ReadOptions reading;                    // what the user said of the file
  std::optional<NamedSettings> settings;  // unset: never tuned
  std::optional<Outcome> outcome;
  ClipReview review;
  std::vector<Pin> pins;
  std::string rig;       // rig_of() its joints as they were read last; empty: they never were
  InputStamp stamp;      // of its files as they were found last; no hash: they never were
  bool missing = false;  // they are gone, by what is known now; not kept
};

/// Hash of the settings it has now and of how it is read; empty: it was never tuned.
std::string settingsHash(const ProjectClip& clip);

/// Why the verdict, or the outcome, is not about the clip as it is now. None where there is
/// neither.
Staleness staleVerdict(const ProjectClip& clip);
Staleness outdated(const ProjectClip& clip);

/// Clips that belong together.
struct Project {
  QString current;            // path of the clip that is open; empty: none
  CharacterFiles characters;  // what was put on the clips, by their rigs
  bool shows_skin = true;
  std::vector<ProjectClip> clips;
  std::optional<RememberedBatch> batch;  // unset: none was begun

  ProjectClip* find(const QString& path);

  /// Nothing would be lost with it.
  bool isEmpty() const { return clips.empty() && (!batch || batch->clips.empty()); }
};

/// By its extension, .mocapress.
bool isProjectFile(const QString& path);

/// A project file: JSON, with paths relative to its folder.
QByteArray projectText(const Project& project, const QDir& folder);

/// Throws Error, which says what is wrong.
Project parseProject(const QByteArray& text, const QDir& folder);

/// Throws Error, which names the file.
Project readProject(const QString& path);

/// The file holds the old project or the new one at any instant. Makes its folder. Throws Error.
void writeProject(const QString& path, const Project& project);

}  // namespace mocapress
