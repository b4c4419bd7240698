// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

namespace mocapress {

/// The lock of a project that was opened on another computer. The studio there may still be
/// running, or the computer may have gone away: this computer cannot tell.
struct ForeignLock {
  QString host;
  QString user;  // empty: a user that this computer does not know
  QDateTime since;

  bool operator==(const ForeignLock&) const = default;
};

/// Unset if no studio on another computer has locked the project.
std::optional<ForeignLock> foreignLock(const QString& project);

/// Describes where a project in use is open, without a full stop: "walks.mocapress is open in
/// another window of Mocapress", or on which computer, by whom and since when. `name` stands for
/// the project in the text; empty: its path.
QString whereOpen(const QString& project, const QString& name = {});

/// Removes this lock, and no other. Returns the reason for a failure; empty: the lock is gone.
QString removeForeignLock(const QString& project, const ForeignLock& lock);

}  // namespace mocapress
