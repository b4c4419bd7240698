// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

namespace mocapress {

/// The lock of a project that a studio on another computer holds, or left behind when that computer
/// went away. It cannot be told from here which of the two.
struct ForeignLock {
  QString host;
  QString user;  // empty: a user that this computer does not know
  QDateTime since;

  bool operator==(const ForeignLock&) const = default;
};

/// Unset if no studio on another computer has locked the project.
std::optional<ForeignLock> foreignLock(const QString& project);

/// Says where a project that is in use is open: "walks.mocapress is open in another window of
/// Mocapress", or on which computer, by whom and since when; without a full stop. `name` is what to
/// call it; empty: its path.
QString whereOpen(const QString& project, const QString& name = {});

/// Removes this lock, and no other. Returns the reason why it is still there; empty: it is gone.
QString removeForeignLock(const QString& project, const ForeignLock& lock);

}  // namespace mocapress
