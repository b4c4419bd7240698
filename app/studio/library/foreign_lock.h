// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

namespace mocapress {

/// The lock of a project that a studio on another computer holds, or held when that computer went
/// away: nobody here can tell.
struct ForeignLock {
  QString host;
  QString user;
  QDateTime since;
};

/// Unset if no studio on another computer has locked the project.
std::optional<ForeignLock> foreignLock(const QString& project);

/// Removes such a lock. False: there was none, or it cannot be removed.
bool removeForeignLock(const QString& project);

}  // namespace mocapress
