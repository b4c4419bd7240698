// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace mocapress {

/// Which projects there are: the one in use, and those before it. A project with a name lies where
/// the user saved it. One without lies in a folder of the shelf's own, in a file of its own: it is
/// as safe as one with a name, and is found again by its date.
class ProjectShelf {
 public:
  /// `folder`: where the studio keeps its data.
  explicit ProjectShelf(const QString& folder);

  /// The project that was used last, though its file may be gone; empty: there was none yet.
  QString inUse() const;

  /// This one is in use from now on. Throws WriteError.
  void use(const QString& path) const;

  /// All whose files are there, those used last first.
  QStringList projects() const;

  /// A file for a project without a name, which nobody has yet. Its folder is there.
  QString unnamedPath() const;

  bool isUnnamed(const QString& path) const;

 private:
  QString list() const { return folder_ + QStringLiteral("/recent.json"); }
  QString unnamedFolder() const { return folder_ + QStringLiteral("/projects"); }
  QStringList listed() const;

  QString folder_;  // absolute
};

}  // namespace mocapress
