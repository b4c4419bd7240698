// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/studio/library/project_shelf.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSet>
#include <QTemporaryDir>
#include <thread>
#include <vector>

#include "app/studio/library/project.h"

namespace mocapress {
namespace {

class AProjectShelf : public testing::Test {
 protected:
  QString folder() const { return QDir(directory_.path()).canonicalPath(); }
  QString named(const char* name) const {
    return folder() + QLatin1Char('/') + QString::fromLatin1(name) + QStringLiteral(".mocapress");
  }

  static QString write(const QString& path) {
    writeProject(path, {});
    return path;
  }

  QTemporaryDir directory_;
  ProjectShelf shelf_{directory_.filePath(QStringLiteral("data"))};
};

TEST_F(AProjectShelf, IsEmptyToBeginWith) {
  EXPECT_TRUE(shelf_.inUse().isEmpty());
  EXPECT_TRUE(shelf_.projects().isEmpty());
}

TEST_F(AProjectShelf, KnowsFromRunToRunWhichProjectIsInUseAndWhichWereBefore) {
  const QString knights = write(named("knights"));
  const QString unnamed = write(shelf_.unnamedPath());
  shelf_.use(knights);
  shelf_.use(unnamed);
  const ProjectShelf next(directory_.filePath(QStringLiteral("data")));
  EXPECT_EQ(next.inUse(), unnamed);
  EXPECT_EQ(next.projects(), QStringList({unnamed, knights}));
  next.use(knights);
  EXPECT_EQ(shelf_.inUse(), knights);
  EXPECT_EQ(shelf_.projects(), QStringList({knights, unnamed}));
}

TEST_F(AProjectShelf, UnnamedProjectsHaveFilesOfTheirOwn) {
  QSet<QString> paths;
  for (int i = 0; i < 100; ++i) paths.insert(shelf_.unnamedPath());
  EXPECT_EQ(paths.size(), 100);
  for (const QString& path : paths) EXPECT_TRUE(shelf_.isUnnamed(path));
  EXPECT_FALSE(shelf_.isUnnamed(named("knights")));
}

TEST_F(AProjectShelf, FindsUnnamedProjectsWithoutItsList) {
  const QString unnamed = write(shelf_.unnamedPath());
  shelf_.use(unnamed);
  for (const char* text : {"", "{\"projects\": ", "[]"}) {
    QFile list(directory_.filePath(QStringLiteral("data/recent.json")));
    ASSERT_TRUE(list.open(QIODevice::WriteOnly | QIODevice::Truncate));
    list.write(text);
    list.close();
    EXPECT_EQ(shelf_.inUse(), unnamed);
    EXPECT_EQ(shelf_.projects(), QStringList(unnamed));
  }
}

TEST_F(AProjectShelf, LeavesOutWhatIsGoneButKnowsThatItWasInUse) {
  const QString knights = write(named("knights"));
  shelf_.use(knights);
  ASSERT_TRUE(QFile::remove(knights));
  EXPECT_TRUE(shelf_.projects().isEmpty());
  EXPECT_EQ(shelf_.inUse(), knights);
}

TEST_F(AProjectShelf, LosesNothingWhenTwoStudiosUseItAtOnce) {
  std::vector<QString> paths;
  for (int i = 0; i < 4; ++i) paths.push_back(write(shelf_.unnamedPath()));
  {
    std::vector<std::jthread> studios;
    for (const QString& path : paths)
      studios.emplace_back([this, path] { ProjectShelf(shelf_).use(path); });
  }
  QFile list(directory_.filePath(QStringLiteral("data/recent.json")));
  ASSERT_TRUE(list.open(QIODevice::ReadOnly));
  const QByteArray text = list.readAll();
  for (const QString& path : paths) EXPECT_TRUE(text.contains(QFileInfo(path).fileName().toUtf8()));
}

}  // namespace
}  // namespace mocapress
