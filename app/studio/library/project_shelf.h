// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace mocapress {

/// The list of projects: the one in use and earlier ones. A named project lies where the user saved
/// it. An unnamed one has a file in the shelf's own folder: it is as safe as a named one, and its
/// file name begins with the date.
class ProjectShelf {
 public:
  /// `folder` holds the studio's data.
  explicit ProjectShelf(const QString& folder);

  /// The project used last, whose file may be gone; empty: none so far.
  QString inUse() const;

  /// Makes this the project in use. Throws WriteError.
  void use(const QString& path) const;

  /// All projects whose files exist, last used first.
  QStringList projects() const;

  /// A new path for an unnamed project, in a folder that exists.
  QString unnamedPath() const;

  bool isUnnamed(const QString& path) const;

 private:
  QString list() const { return folder_ + QStringLiteral("/recent.json"); }
  QString unnamedFolder() const { return folder_ + QStringLiteral("/projects"); }
  QStringList listed() const;

  QString folder_;  // absolute path
};

}  // namespace mocapress
