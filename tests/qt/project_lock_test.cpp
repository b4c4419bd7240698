// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSysInfo>
#include <QTemporaryDir>
#include <optional>

#include "app/studio/library/foreign_lock.h"
#include "app/studio/library/kept_project.h"

namespace mocapress {
namespace {

class AProjectLock : public testing::Test {
 protected:
  void writeLock(const QByteArray& text) const {
    QFile lock(ProjectLock::fileOf(project_));
    ASSERT_TRUE(lock.open(QIODevice::WriteOnly));
    lock.write(text);
  }

  QTemporaryDir directory_;
  QString project_ = directory_.filePath(QStringLiteral("knights.mocapress"));
};

TEST_F(AProjectLock, IsHeldByOneAtATime) {
  {
    const ProjectLock first(project_);
    EXPECT_TRUE(first.held());
    EXPECT_FALSE(first.wasLeftBehind());
    const ProjectLock second(project_);
    EXPECT_FALSE(second.held());
    EXPECT_TRUE(second.inUse());
  }
  EXPECT_FALSE(QFile::exists(ProjectLock::fileOf(project_))) << "nothing is left behind";
  EXPECT_TRUE(ProjectLock(project_).held());
}

TEST_F(AProjectLock, ALockOfADeadProcessWasLeftBehind) {
  writeLock("2147483000\nmocapress-studio\n" + QSysInfo::machineHostName().toUtf8() + "\n");
  const ProjectLock lock(project_);
  EXPECT_TRUE(lock.held());
  EXPECT_TRUE(lock.wasLeftBehind());
}

TEST_F(AProjectLock, ALockOfAnotherMachineIsInUse) {
  writeLock("1\nmocapress-studio\nelsewhere\n");
  EXPECT_TRUE(ProjectLock(project_).inUse());
}

TEST_F(AProjectLock, ALockOfAnotherMachineNamesItAndIsTakenOver) {
  writeLock("1\nmocapress-studio\nelsewhere\n");
  const std::optional<ForeignLock> lock = foreignLock(project_);
  ASSERT_TRUE(lock);
  EXPECT_EQ(lock->host, QStringLiteral("elsewhere"));
  EXPECT_EQ(lock->user, QFileInfo(directory_.path()).owner());
  EXPECT_TRUE(lock->since.isValid());
  EXPECT_EQ(removeForeignLock(project_, *lock), QString());
  EXPECT_TRUE(ProjectLock(project_).held());
}

TEST_F(AProjectLock, OnlyTheForeignLockThatWasShownIsTakenOver) {
  writeLock("1\nmocapress-studio\nelsewhere\n");
  const std::optional<ForeignLock> shown = foreignLock(project_);
  ASSERT_TRUE(shown);
  QFile::remove(ProjectLock::fileOf(project_));
  writeLock("1\nmocapress-studio\nin-a-third-place\n");
  EXPECT_TRUE(removeForeignLock(project_, *shown).contains(project_));
  EXPECT_EQ(foreignLock(project_)->host, QStringLiteral("in-a-third-place"));
  QFile::remove(ProjectLock::fileOf(project_));
  EXPECT_EQ(removeForeignLock(project_, *shown), QString()) << "it is gone by itself";
}

TEST_F(AProjectLock, AForeignLockThatMayNotBeWrittenIsTakenOver) {
  writeLock("1\nmocapress-studio\nelsewhere\n");
  QFile::setPermissions(ProjectLock::fileOf(project_), QFile::ReadOwner);
  EXPECT_EQ(removeForeignLock(project_, *foreignLock(project_)), QString());
  EXPECT_FALSE(foreignLock(project_));
}

TEST_F(AProjectLock, AForeignLockOfAnotherTimeIsNotTakenOver) {
  writeLock("1\nmocapress-studio\nelsewhere\n");
  ForeignLock earlier = *foreignLock(project_);
  earlier.since = earlier.since.addSecs(-60);
  EXPECT_FALSE(removeForeignLock(project_, earlier).isEmpty());
  EXPECT_TRUE(foreignLock(project_));
}

TEST_F(AProjectLock, AForeignLockThatIsStillHeldStaysAndIsNamed) {
  const ProjectLock holder(project_);  // locks the file itself, as a studio on a network may
  writeLock("1\nmocapress-studio\nelsewhere\n");
  const QString reason = removeForeignLock(project_, *foreignLock(project_));
  EXPECT_TRUE(reason.contains(ProjectLock::fileOf(project_))) << qPrintable(reason);
  EXPECT_TRUE(foreignLock(project_));
}

TEST_F(AProjectLock, ThatWasTakenOverIsLostAndLeftToItsNewOwner) {
  const QString file = ProjectLock::fileOf(project_);
  {
    const ProjectLock first(project_);
    EXPECT_FALSE(first.lost());
    QFile::remove(file);
    EXPECT_TRUE(first.lost()) << "the new owner may have ended already";
    writeLock("1\nmocapress-studio\nelsewhere\n");
    EXPECT_TRUE(first.lost());
  }
  ASSERT_TRUE(foreignLock(project_));
  EXPECT_EQ(foreignLock(project_)->host, QStringLiteral("elsewhere"));
}

TEST_F(AProjectLock, IsNotLostWhileItsFolderIsAway) {
  const QString folder = directory_.filePath(QStringLiteral("share"));
  QDir().mkpath(folder);
  const ProjectLock lock(folder + QStringLiteral("/knights.mocapress"));
  QDir().rename(folder, folder + QStringLiteral("-away"));
  EXPECT_FALSE(lock.lost());
  QDir().rename(folder + QStringLiteral("-away"), folder);
  EXPECT_FALSE(lock.lost());
}

TEST_F(AProjectLock, ALockOfThisMachineIsNotTakenOver) {
  const ProjectLock lock(project_);
  EXPECT_FALSE(foreignLock(project_));
  EXPECT_FALSE(removeForeignLock(project_, {}).isEmpty());
  EXPECT_TRUE(ProjectLock(project_).inUse());
}

TEST_F(AProjectLock, ALockWithoutAnOwnerWasLeftBehind) {
  writeLock("");
  const ProjectLock lock(project_);
  EXPECT_TRUE(lock.held());
  EXPECT_TRUE(lock.wasLeftBehind());
}

TEST_F(AProjectLock, InAFolderThatIsNotThereIsNotHeldNorInUse) {
  const ProjectLock lock(directory_.filePath(QStringLiteral("no/such/folder/a.mocapress")));
  EXPECT_FALSE(lock.held());
  EXPECT_FALSE(lock.inUse());
}

}  // namespace
}  // namespace mocapress
