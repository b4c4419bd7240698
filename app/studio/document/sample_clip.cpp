// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/sample_clip.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace mocapress {

QString sampleClip() {
  const QString installed =
      QCoreApplication::applicationDirPath() + QStringLiteral("/../share/mocapress/samples");
  for (const QString& directory : {installed, QStringLiteral(MOCAPRESS_SAMPLES)}) {
    const QFileInfo clip(directory + QStringLiteral("/human_walk.amc"));
    if (clip.exists()) return clip.canonicalFilePath();
  }
  return {};
}

}  // namespace mocapress
