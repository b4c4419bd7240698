// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLockFile>
#include <QString>

namespace mocapress {

/// Keeps a project for one studio: two that wrote the same file would undo each other's work. The
/// lock is a hidden file beside the project. It names its process, so that a lock left behind by a
/// crash is known as one; it holds in network folders without file locks too.
class ProjectLock {
 public:
  explicit ProjectLock(const QString& project);

  bool held() const { return lock_.isLocked(); }

  /// Another studio holds it. Neither held nor in use: the folder takes no files.
  bool inUse() const { return !held() && lock_.error() == QLockFile::LockFailedError; }

  /// Held now, but the studio that held it last never let it go.
  bool wasLeftBehind() const { return held() && existed_; }

  /// The file beside `project`.
  static QString fileOf(const QString& project);

 private:
  bool existed_;  // before this one asked for it
  QLockFile lock_;
};

}  // namespace mocapress
