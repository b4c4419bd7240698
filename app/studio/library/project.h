// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QString>
#include <optional>
#include <vector>

#include "app/studio/document/named_settings.h"
#include "widgets/models/library_model.h"

namespace mocapress {

/// A clip of a project, and all that was decided about it.
struct ProjectClip {
  QString path;                           // absolute
  QString skeleton;                       // for an .amc; empty: the one beside it
  ReadOptions reading;                    // what the user said of the file
  std::optional<NamedSettings> settings;  // unset: never tuned
  std::optional<Outcome> outcome;
  Verdict verdict = Verdict::None;
  QString note;
  std::vector<Pin> pins;
};

/// Clips that belong together.
struct Project {
  QString current;    // path of the clip that is open; empty: none
  QString character;  // path of what was put on the clips; empty: each has its own
  bool shows_skin = true;
  std::vector<ProjectClip> clips;

  ProjectClip* find(const QString& path);
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
