// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace mocapress {
namespace {

constexpr int kMostRemembered = 12;
const QString kList = QStringLiteral("recent-files");
const QString kPath = QStringLiteral("path");
const QString kSkeleton = QStringLiteral("skeleton");

}  // namespace

QList<RecentFile> recentFiles() {
  QSettings settings;
  QList<RecentFile> files;
  const int count = settings.beginReadArray(kList);
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    const RecentFile file{settings.value(kPath).toString(), settings.value(kSkeleton).toString()};
    if (QFileInfo::exists(file.path)) files << file;
  }
  settings.endArray();
  return files;
}

QString rememberedSkeleton(const QString& path) {
  for (const RecentFile& file : recentFiles())
    if (file.path == QFileInfo(path).absoluteFilePath()) return file.skeleton;
  return {};
}

void rememberRecentFile(const RecentFile& file) {
  const RecentFile absolute{QFileInfo(file.path).absoluteFilePath(), file.skeleton};
  QList<RecentFile> files = recentFiles();
  files.removeIf([&](const RecentFile& other) { return other.path == absolute.path; });
  files.prepend(absolute);
  files.resize(std::min<qsizetype>(files.size(), kMostRemembered));

  QSettings settings;
  settings.beginWriteArray(kList, static_cast<int>(files.size()));
  for (int i = 0; i < files.size(); ++i) {
    settings.setArrayIndex(i);
    settings.setValue(kPath, files[i].path);
    settings.setValue(kSkeleton, files[i].skeleton);
  }
  settings.endArray();
}

}  // namespace mocapress
