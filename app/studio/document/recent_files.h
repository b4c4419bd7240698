// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

namespace mocapress {

struct RecentFile {
  QString path;
  QString skeleton;  // chosen by hand; empty: found beside the clip
  bool operator==(const RecentFile&) const = default;
};

/// Newest first, those that still exist, kept in the user's settings.
QList<RecentFile> recentFiles();

/// The .asf that was chosen by hand for this clip; empty: none.
QString rememberedSkeleton(const QString& path);

void rememberRecentFile(const RecentFile& file);

}  // namespace mocapress
