// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/document/clip_files.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>

namespace mocapress {
namespace {

class RecentFiles : public testing::Test {
 protected:
  RecentFiles() { QSettings().clear(); }
  ~RecentFiles() override { QSettings().clear(); }

  QString make(const QString& name) const {
    QFile file(directory_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    return file.fileName();
  }

  QTemporaryDir directory_;
};

TEST_F(RecentFiles, NewestFirstEachOnce) {
  const QString a = make(QStringLiteral("a.bvh"));
  const QString b = make(QStringLiteral("b.amc"));
  rememberRecentFile({a, {}});
  rememberRecentFile({b, {}});
  rememberRecentFile({a, QStringLiteral("s.asf")});
  EXPECT_EQ(recentFiles(), (QList<RecentFile>{{a, QStringLiteral("s.asf")}, {b, {}}}));
}

TEST_F(RecentFiles, ForgetsWhatIsGone) {
  const QString a = make(QStringLiteral("a.bvh"));
  rememberRecentFile({a, {}});
  QFile::remove(a);
  EXPECT_TRUE(recentFiles().isEmpty());
}

TEST_F(RecentFiles, KeepsABoundedNumber) {
  for (int i = 0; i < 30; ++i) rememberRecentFile({make(QString::number(i)), {}});
  EXPECT_EQ(recentFiles().size(), 12);
  EXPECT_TRUE(recentFiles().front().path.endsWith(QStringLiteral("29")));
}

}  // namespace
}  // namespace mocapress
